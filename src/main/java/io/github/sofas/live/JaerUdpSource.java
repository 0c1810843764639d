package io.github.sofas.live;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.recording.Chip;
import io.github.sofas.recording.JaerAddress;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What jAER's AEUnicast output sends with its standard settings: datagrams of a sequence number and then address and
 * time in µs of each event, 32 bits each, big-endian.
 */
public final class JaerUdpSource extends LiveSource {
    /** Where jAER sends unless told otherwise. */
    public static final int JAER_PORT = 8991;

    private static final int DATAGRAM_BYTES = 65_535;
    private static final int HEADER_BYTES = 4;
    private static final int EVENT_BYTES = 8;
    /** Room for a tenth of a second at 5 million events/s, if the system gives as much. */
    private static final int SOCKET_BUFFER_BYTES = 4 << 20;
    /** A sequence number this little behind is of a datagram that was overtaken; any other of a new sender. */
    private static final int OVERTAKEN = 64;
    /** A step back by more than this is no disorder: the sender's time was set anew. */
    private static final long TIME_RESET_US = 1_000_000;

    private final DatagramSocket socket;
    private final JaerAddress addresses;
    private final Thread thread;

    private boolean anyReceived;
    private int lastSequence;
    private long offsetUs;
    private int lastRawUs;
    private long newestUs;
    private boolean anyTime;

    private long datagrams;
    private volatile long lost;
    private long overtaken;
    private long restarts;
    private long otherRecords;
    private long oddBytes;
    private long outside;
    private long stepsBack;
    private long timeWraps;
    private long timeResets;

    /**
     * Starts to listen.
     *
     * @param address where to; port 0 for any that is free
     * @param chip whose addresses are sent
     * @throws EventSourceException where the port cannot be had
     */
    public JaerUdpSource(InetSocketAddress address, Chip chip) throws EventSourceException {
        super("UDP port " + address.getPort(), chip, DATAGRAM_BYTES / EVENT_BYTES);
        addresses = new JaerAddress(chip);
        try {
            socket = new DatagramSocket(address);
            socket.setReceiveBufferSize(SOCKET_BUFFER_BYTES);
        } catch (SocketException e) {
            throw new EventSourceException("[" + name() + "] cannot be listened to: " + e.getMessage(), e);
        }
        thread = new Thread(this::receive, "jAER datagrams");
        thread.setPriority(Thread.MAX_PRIORITY);
        thread.setDaemon(true);
        thread.start();
    }

    /** The port that is listened to. */
    public int port() {
        return socket.getLocalPort();
    }

    @Override
    public String formatName() {
        return "jAER AEUnicast";
    }

    private void receive() {
        byte[] data = new byte[DATAGRAM_BYTES];
        DatagramPacket datagram = new DatagramPacket(data, data.length);
        ByteBuffer buffer = ByteBuffer.wrap(data);
        while (true) {
            datagram.setLength(data.length);
            try {
                socket.receive(datagram);
            } catch (IOException e) {
                // Closed by stop(), which ends the queue without a fault before this does.
                if (!socket.isClosed()) {
                    queue.end(new EventSourceException("[" + name() + "] cannot be received: " + e.getMessage(), e));
                }
                return;
            }
            PacketQueue.Packet packet = arrival();
            decode(buffer, datagram.getLength(), packet.events);
            handOn(packet);
        }
    }

    private void decode(ByteBuffer data, int length, EventBatch batch) {
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

    /** Whether a datagram is one of those that follow the last. */
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

    /** Time that never falls, in 64 bits. */
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

    @Override
    void shutDown() {
        queue.end(null);
        socket.close();
        boolean interrupted = false;
        while (thread.isAlive()) {
            try {
                thread.join();
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public long packetsLost() {
        return lost;
    }

    @Override
    public Map<String, Long> counts() {
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

    @Override
    Map<String, Long> undecodable() {
        return Map.of("outside_sensor", outside);
    }

    @Override
    List<String> describeFaults() {
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

    @Override
    void release() {
        // The socket was closed by stop().
    }
}
