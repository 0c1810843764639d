package io.github.sofas.live;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.recording.Chip;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The events of one camera on the USB. {@link Cameras} opens the camera, and {@link #start} starts it. From then on,
 * the thread of the USB transfers decodes the events and puts them into the queue. A lost transfer costs only its own
 * events. The stream ends when the camera is unplugged, or when too many transfers in a row are lost.
 */
public final class CameraSource extends LiveSource {
    /**
     * This many lost transfers in a row end the stream. A broken cable or port gives nothing but faults, and each lost
     * transfer is submitted again at once.
     */
    private static final int MOST_LOST_IN_A_ROW = 100;

    private final CameraModel model;
    private final UsbConnection usb;
    private final CameraProtocol protocol;
    private final CameraDecoder decoder;
    private final Map<UsbConnection.TransferFault, Long> lost = new EnumMap<>(UsbConnection.TransferFault.class);
    private volatile boolean gone;
    private volatile long packetsLost;
    private long transfers;
    private int lostInARow;

    CameraSource(String name, Chip chip, CameraModel model, UsbConnection usb, CameraProtocol protocol,
                 CameraDecoder decoder) {
        super(name, chip, decoder.mostEvents(model.transferBytes));
        this.model = model;
        this.usb = usb;
        this.protocol = protocol;
        this.decoder = decoder;
    }

    /** {@return the kind of camera} */
    public CameraModel model() {
        return model;
    }

    @Override
    public String formatName() {
        return (model == CameraModel.DVS128 ? "DVS128" : "DAVIS") + " over USB";
    }

    /**
     * Configures the camera and starts its stream.
     *
     * @param biases bias currents, set before the camera starts
     * @throws EventSourceException if a request to the camera fails
     */
    public void start(Biases biases) throws EventSourceException {
        try {
            protocol.configure(biases);
            usb.startTransfers(model.endpoint, CameraModel.TRANSFERS, model.transferBytes, new Transfers());
            protocol.start();
        } catch (UsbException e) {
            throw new EventSourceException("[" + name() + "] cannot be started: " + e.getMessage(), e);
        }
    }

    /** Receives the transfers; called on their thread. */
    private final class Transfers implements UsbConnection.Receiver {
        @Override
        public void received(byte[] data, int length) {
            PacketQueue.Packet packet = arrival();
            decoder.decode(data, length, packet.events);
            transfers++;
            lostInARow = 0;
            handOn(packet);
        }

        @Override
        public void lost(UsbConnection.TransferFault fault) {
            lost.merge(fault, 1L, Long::sum);
            packetsLost++;
            decoder.lose();
            if (++lostInARow == MOST_LOST_IN_A_ROW) {
                queue.end(new EventSourceException("[" + name() + "] " + lostInARow
                    + " transfers in a row were lost, the last by " + words(fault)));
            }
        }

        @Override
        public void ended(UsbException cause) {
            gone = true;
            queue.end(new EventSourceException("[" + name() + "] " + (cause.fault() == UsbException.Fault.GONE
                ? "the camera was unplugged" : "the transfers have ended: " + cause.getMessage()), cause));
        }
    }

    @Override
    void shutDown() {
        if (!gone) {
            try {
                protocol.stop();
            } catch (UsbException e) {
                // Unplugged or broken: the transfers report the fault, and nothing is left to stop.
                gone = true;
            }
        }
        usb.stopTransfers();
    }

    @Override
    public long packetsLost() {
        return packetsLost;
    }

    @Override
    public Map<String, Long> counts() {
        Map<String, Long> counts = new LinkedHashMap<>();
        counts.put("transfers", transfers);
        for (UsbConnection.TransferFault fault : UsbConnection.TransferFault.values()) {
            counts.put("transfers_lost_by_" + fault.name().toLowerCase(Locale.ROOT), lost.getOrDefault(fault, 0L));
        }
        counts.putAll(decoder.counts());
        return counts;
    }

    @Override
    Map<String, Long> undecodable() {
        return decoder.dropped();
    }

    @Override
    List<String> describeFaults() {
        List<String> faults = new ArrayList<>();
        lost.forEach((fault, count) -> faults.add(count + (count == 1 ? " transfer" : " transfers") + " lost by "
            + words(fault)));
        return faults;
    }

    private static String words(UsbConnection.TransferFault fault) {
        return switch (fault) {
            case STALL -> "a stall of the endpoint";
            case ERROR -> "an error on the wire";
            case OVERFLOW -> "more data than asked for";
        };
    }

    @Override
    void release() {
        usb.close();
    }
}
