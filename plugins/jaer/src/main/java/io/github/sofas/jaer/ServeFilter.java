package io.github.sofas.jaer;

import ch.unizh.ini.jaer.projects.rbodo.opticalflow.AbstractMotionFlowIMU;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.reflect.Constructor;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.event.BasicEvent;
import net.sf.jaer.event.EventPacket;
import net.sf.jaer.event.OutputEventIterator;
import net.sf.jaer.event.PolarityEvent;
import net.sf.jaer.event.orientation.ApsDvsMotionOrientationEvent;

/**
 * Runs one of jAER's motion-flow filters, without a viewer, on events from the standard input, and writes their flow to
 * the standard output. Its arguments are {@code FILTER WIDTH HEIGHT}. {@link StartFilter} starts this program with
 * jAER's classes. All numbers are big-endian; the axes are the engine's.
 *
 * <p>Input, per packet: the number of events, then time in µs, x, y and polarity of each (long, short, short, byte). A
 * number below 0 ends the program. Output: {@value #READY} once. Then, per packet: the time that the filter took in ns,
 * then vx, vy (NaN without flow) and the segment of each event (float, float, int).
 */
public final class ServeFilter {
    /** The number that is written when the filter is ready. */
    public static final int READY = 0x50fa5;
    private static final String CHIP = "ch.unizh.ini.jaer.chip.retina.DVS128";

    private ServeFilter() {
    }

    /** Serves until the input ends it; ends with exit code 1 and a stack trace after any failure. */
    public static void main(String[] arguments) {
        int code = 1;
        try {
            serve(arguments[0], Integer.parseInt(arguments[1]), Integer.parseInt(arguments[2]));
            code = 0;
        } catch (Throwable e) {
            // also errors of class loading and of the display: otherwise a thread of jAER would keep this process alive
            e.printStackTrace();
        }
        // not exit: hooks of jAER may wait for a display
        Runtime.getRuntime().halt(code);
    }

    private static void serve(String filterClass, int width, int height) throws Exception {
        DataOutputStream out = new DataOutputStream(new BufferedOutputStream(new FileOutputStream(FileDescriptor.out),
            1 << 16));
        // text that jAER prints must not get between the numbers
        System.setOut(new PrintStream(new FileOutputStream(FileDescriptor.err), true));
        DataInputStream in = new DataInputStream(new BufferedInputStream(System.in, 1 << 16));
        AEChip chip = (AEChip) Class.forName(CHIP).getConstructor().newInstance();
        chip.setSizeX(width);
        chip.setSizeY(height);
        AbstractMotionFlowIMU filter = make(filterClass, chip);
        filter.initFilter();
        filter.setFilterEnabled(true);
        filter.setDisplayRawInput(false);
        filter.measureAccuracy = false;
        out.writeInt(READY);
        out.flush();
        for (int n = in.readInt(); n >= 0; n = in.readInt()) {
            serve(in, n, filter, height, out);
            out.flush();
        }
    }

    private static AbstractMotionFlowIMU make(String name, AEChip chip) throws ReflectiveOperationException {
        Constructor<?> constructor = Class.forName(name).getConstructor(AEChip.class);
        try {
            return (AbstractMotionFlowIMU) constructor.newInstance(chip);
        } catch (ReflectiveOperationException e) {
            // at their first construction, some filters store preferences and fail; the second succeeds
            return (AbstractMotionFlowIMU) constructor.newInstance(chip);
        }
    }

    private static void serve(DataInputStream in, int n, AbstractMotionFlowIMU filter, int height,
                              DataOutputStream out) throws IOException {
        EventPacket<PolarityEvent> packet = new EventPacket<>(PolarityEvent.class);
        OutputEventIterator<PolarityEvent> events = packet.outputIterator();
        PolarityEvent[] sent = new PolarityEvent[n];
        for (int i = 0; i < n; i++) {
            PolarityEvent event = events.nextOutput();
            event.timestamp = (int) in.readLong();
            event.x = in.readShort();
            event.y = (short) (height - 1 - in.readShort());
            boolean on = in.readByte() > 0;
            event.polarity = on ? PolarityEvent.Polarity.On : PolarityEvent.Polarity.Off;
            event.type = (byte) (on ? 1 : 0);
            sent[i] = event;
        }
        long start = System.nanoTime();
        EventPacket<?> flow = filter.filterPacket(packet);
        out.writeLong(System.nanoTime() - start);
        int i = 0;
        for (BasicEvent labelled : flow) {
            ApsDvsMotionOrientationEvent event = (ApsDvsMotionOrientationEvent) labelled;
            // filters drop events, but keep the order of the others
            while (i < n && !isSame(sent[i], event)) {
                write(out, Float.NaN, Float.NaN, 0);
                i++;
            }
            if (i < n) {
                boolean has = event.hasDirection;
                int segment = filter instanceof SofasFlow ? ((SofasFlow) filter).lastFlow().segment[i] : 1;
                write(out, has ? event.velocity.x : Float.NaN, has ? -event.velocity.y : Float.NaN, has ? segment : 0);
                i++;
            }
        }
        for (; i < n; i++) {
            write(out, Float.NaN, Float.NaN, 0);
        }
    }

    private static boolean isSame(PolarityEvent a, PolarityEvent b) {
        return a.timestamp == b.timestamp && a.x == b.x && a.y == b.y && a.polarity == b.polarity;
    }

    private static void write(DataOutputStream out, float vx, float vy, int segment) throws IOException {
        out.writeFloat(vx);
        out.writeFloat(vy);
        out.writeInt(segment);
    }
}
