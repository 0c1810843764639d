package io.github.sofas.live;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.recording.Chip;
import io.github.sofas.recording.JaerAddress;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;

/**
 * The events that jAER's AEUnicast output sends over UDP with its standard settings. A thread of the source receives
 * the datagrams; {@link JaerDatagramDecoder} describes and decodes their format.
 */
public final class JaerUdpSource extends LiveSource {
    /** The port to which jAER sends by default. */
    public static final int JAER_PORT = 8991;

    private static final int DATAGRAM_BYTES = 65_535;
    /** Room for a tenth of a second at 5 million events/s, if the system gives as much. */
    private static final int SOCKET_BUFFER_BYTES = 4 << 20;

    private final DatagramSocket socket;
    private final JaerDatagramDecoder decoder;
    private final Thread thread;

    /**
     * Starts to listen.
     *
     * @param address address and port to listen to; port 0 for any port that is free
     * @param chip chip whose pixel addresses are sent
     * @throws EventSourceException if the port cannot be opened
     */
    public JaerUdpSource(InetSocketAddress address, Chip chip) throws EventSourceException {
        super("UDP port " + address.getPort(), chip, DATAGRAM_BYTES / JaerDatagramDecoder.EVENT_BYTES);
        decoder = new JaerDatagramDecoder(new JaerAddress(chip));
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

    /** {@return the port that the source listens to} */
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
                // The socket is closed by stop(), which has ended the queue without a fault before.
                if (!socket.isClosed()) {
                    queue.end(new EventSourceException("[" + name() + "] cannot be received: " + e.getMessage(), e));
                }
                return;
            }
            PacketQueue.Packet packet = arrival();
            decoder.decode(buffer, datagram.getLength(), packet.events);
            handOn(packet);
        }
    }

    @Override
    void shutDown() {
        queue.end(null);
        socket.close();
        ThreadEnd.await(thread);
    }

    @Override
    public long packetsLost() {
        return decoder.lost();
    }

    @Override
    public Map<String, Long> counts() {
        return decoder.counts();
    }

    @Override
    Map<String, Long> undecodable() {
        return Map.of("outside_sensor", decoder.outside());
    }

    @Override
    List<String> describeFaults() {
        return decoder.faults();
    }

    @Override
    void release() {
        // The socket was closed by stop().
    }
}
