package io.github.sofas.jaer;

import io.github.sofas.flow.Segment;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.logging.Logger;

/**
 * The files that are written while the user has a session switched on. Packets and segments come on the engine's
 * thread.
 */
final class Session {
    private final Logger log;
    private volatile SessionLog files;

    Session(Logger log) {
        this.log = log;
    }

    void begin(Path name) {
        try {
            files = SessionLog.open(name);
        } catch (IOException failure) {
            log.warning("SOFAS could not write " + name + ": " + failure);
        }
    }

    boolean isOn() {
        return files != null;
    }

    /** Whether the session is on, but cannot write any more. */
    boolean hasFailed() {
        SessionLog now = files;
        return now != null && now.hasFailed();
    }

    void add(LabelledPacket packet) {
        SessionLog now = files;
        if (now != null) {
            now.add(packet.batch(), packet.flow());
        }
    }

    void add(Segment ended) {
        SessionLog now = files;
        if (now != null) {
            now.add(ended);
        }
    }

    /** Ends the session, with the segments that are tracked now. */
    void end(List<Segment> living) {
        SessionLog ending = files;
        files = null;
        write(ending, living);
    }

    /** Writes the flow of one packet, and the segments that are tracked now. */
    void writeOnce(Path name, LabelledPacket packet, List<Segment> living) {
        try {
            SessionLog once = SessionLog.open(name);
            once.add(packet.batch(), packet.flow());
            write(once, living);
        } catch (IOException failure) {
            log.warning("SOFAS could not write " + name + ": " + failure);
        }
    }

    private void write(SessionLog ending, List<Segment> living) {
        try {
            log.info(ending.close(living));
        } catch (IOException failure) {
            log.warning("SOFAS could not write " + ending.name() + ": " + failure);
        }
    }
}
