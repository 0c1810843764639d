package io.github.sofas.live;

import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.JaerAddress;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Decodes the datagrams of jAER into events. A datagram holds a sequence number, then the address and the time in µs of
 * each event, all of them big-endian words of 32 bits. The decoder counts missing datagrams, and gives times that never
 * decrease. Used by one thread.
 */
final class JaerDatagramDecoder {
    static final int EVENT_BYTES = 8;

    private static final int HEADER_BYTES = 4;
    /**
     * A sequence number that is less than this behind the last one belongs to a datagram that was overtaken. Any other
     * that is behind belongs to a new sender.
     */
    private static final int OVERTAKEN = 64;
    /** A step back by more than this is no disorder: the sender's time was reset. */
    private static final long TIME_RESET_US = 1_000_000;

    private final JaerAddress addresses;

    private boolean anyReceived;
    private int lastSequence;
    private long offsetUs;
    private int lastRawUs;
    private long newestUs;
    private boolean anyTime;

    private long datagrams;
    /** Any thread may read it. */
    private volatile long lost;
    private long overtaken;
    private long restarts;
    private long otherRecords;
    private long oddBytes;
    private long outside;
    private long stepsBack;
    private long timeWraps;
    private long timeResets;

    JaerDatagramDecoder(JaerAddress addresses) {
        this.addresses = addresses;
    }

    /**
     * Appends the events of a datagram.
     *
     * @param batch receives the events; has room for all that fit into the datagram
     */
    void decode(ByteBuffer data, int length, EventBatch batch) {
        datagrams++;
        if (length < HEADER_BYTES) {
            oddBytes += length;
            return;
        }
        if (!inSequence(data.getInt(0))) {
            return;
        }
        oddBytes += (length - HEADER_BYTES) % EVENT_BYTES;
        for (int p = HEADER_BYTES; p + EVENT_BYTES <= length; p += EVENT_BYTES) {
            int address = data.getInt(p);
            if (!addresses.isEvent(address)) {
                otherRecords++;
                continue;
            }
            int x = addresses.x(address);
            int y = addresses.y(address);
            if ((x | y) < 0) {
                outside++;
                continue;
            }
            batch.add(time(data.getInt(p + Integer.BYTES)), x, y, addresses.polarity(address));
        }
    }

    /** Whether a datagram is in sequence, and thus to be decoded; counts lost and overtaken datagrams and restarts. */
    private boolean inSequence(int sequence) {
        int ahead = sequence - lastSequence;
        if (anyReceived && ahead > 0) {
            lost += ahead - 1;
        } else if (anyReceived && ahead > -OVERTAKEN && sequence > 1) {
            overtaken++;
            return false;
        } else if (anyReceived) {
            restarts++;
        }
        anyReceived = true;
        lastSequence = sequence;
        return true;
    }

    /** Extends a time of the sender to 64 bits; the results never decrease. */
    private long time(int rawUs) {
        if (!anyTime) {
            anyTime = true;
            newestUs = rawUs;
        }
        if (lastRawUs > 0 && rawUs < 0 && rawUs - lastRawUs > 0) {
            timeWraps++;
            offsetUs += 1L << Integer.SIZE;
        }
        lastRawUs = rawUs;
        long timeUs = rawUs + offsetUs;
        if (timeUs < newestUs - TIME_RESET_US) {
            timeResets++;
            offsetUs = newestUs - rawUs;
        } else if (timeUs < newestUs) {
            stepsBack++;
        }
        newestUs = Math.max(newestUs, rawUs + offsetUs);
        return newestUs;
    }

    /** Number of datagrams that are missing. */
    long lost() {
        return lost;
    }

    /** Number of events that lay outside the sensor. */
    long outside() {
        return outside;
    }

    /** Numbers of all that the stream held besides events, by name. */
    Map<String, Long> counts() {
        Map<String, Long> counts = new LinkedHashMap<>();
        counts.put("datagrams", datagrams);
        counts.put("datagrams_lost", lost);
        counts.put("datagrams_overtaken", overtaken);
        counts.put("sender_restarts", restarts);
        counts.put("steps_back_in_time", stepsBack);
        counts.put("time_wraps", timeWraps);
        counts.put("time_resets", timeResets);
        counts.put("other_records", otherRecords);
        counts.put("odd_bytes", oddBytes);
        return counts;
    }

    /** Describes the faults of the stream for the user, one line each. */
    List<String> faults() {
        List<String> faults = new ArrayList<>();
        if (lost > 0) {
            faults.add(lost + (lost == 1 ? " datagram was lost" : " datagrams were lost"));
        }
        if (overtaken > 0) {
            faults.add(overtaken + (overtaken == 1 ? " datagram that came" : " datagrams that came")
                + " too late was not used");
        }
        return faults;
    }
}
