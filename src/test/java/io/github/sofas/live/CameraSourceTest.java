package io.github.sofas.live;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import java.util.List;
import org.junit.Test;

/** One camera against a transport that only notes what it is asked. */
public class CameraSourceTest {
    private final EventBatch batch = new EventBatch(16);

    /** Pauses are noted among the requests. */
    private static CameraSource open(FakeTransport fake) throws EventSourceException {
        return new Cameras(fake, ms -> fake.requests.add("wait " + ms)).open(null);
    }

    private static CameraSource started(FakeTransport fake) throws EventSourceException {
        CameraSource source = open(fake);
        source.start(Biases.defaults(source.model()));
        return source;
    }

    /** What was asked from the first such request on. */
    private static List<String> from(String first, FakeTransport fake) {
        return fake.requests.subList(fake.requests.indexOf(first), fake.requests.size());
    }

    @Test
    public void asksADavisWhatItIsBeforeAnythingElse() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        CameraSource source = open(fake);
        assertEquals(List.of("open", "close", "open", "claim", "read 6/0", "read 6/7", "read 6/1", "read 6/5",
            "read 6/6", "read 1/0", "read 1/1", "read 1/2"), fake.requests);
        assertEquals("DAVIS240C 00000042", source.name());
        assertEquals("DAVIS240C", source.chip().name());
        assertEquals(new SensorSize(240, 180), source.sensor());
        assertEquals("DAVIS over USB", source.formatName());
    }

    @Test
    public void startsADavisInTheOrderThatItNeeds() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        CameraSource source = open(fake);
        fake.requests.clear();
        source.start(Biases.defaults(CameraModel.DAVIS240C));
        assertEquals(List.of("1/3=0", "2/4=0", "3/2=0", "3/3=0", "3/4=0", "4/0=0", "0/0=0", "0/1=0", "9/0=0", "0/3=0",
            "wait 10", "clear 82", "0/2=0", "0/4=1", "0/5=1", "1/4=0", "1/5=0", "read 1/10", "read 1/30", "read 1/40",
            "read 1/50", "read 1/60", "9/1=30000"), fake.requests.subList(0, 23));
        // 22 biases, then 14 settings of the chip: 128 to 138 and 140 to 142
        assertEquals("5/0=" + 0x427F, fake.requests.get(23));
        assertEquals("5/21=" + 0x8410, fake.requests.get(44));
        assertEquals(List.of("5/128=0", "5/129=0", "5/130=0", "5/131=0", "5/132=0", "5/133=0", "5/134=0", "5/135=0",
            "5/136=1", "5/137=0", "5/138=1", "5/140=0", "5/141=0", "5/142=1", "transfers 8 x 8192 from 82", "0/3=1",
            "wait 200", "9/0=1", "0/1=1", "0/0=1", "wait 50", "1/3=1"), fake.requests.subList(45, 67));
        assertEquals(67, fake.requests.size());
    }

    @Test
    public void switchesTheFiltersOffThatADavisHas() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis(CameraModel.DAVIS346, 5, 346, 260);
        for (int has = 10; has <= 60; has += 10) {
            fake.parameters.put("1/" + has, 1);
        }
        // 80 MHz, 0.8 % fast
        fake.parameters.put("6/5", 80);
        fake.parameters.put("6/6", 1008);
        started(fake);
        assertEquals(List.of("read 1/10", "1/11=260", "1/12=346", "1/13=260", "1/14=346", "1/15=260", "1/16=346",
            "1/17=260", "1/18=346", "1/19=260", "1/20=346", "1/21=260", "1/22=346", "1/23=260", "1/24=346", "1/25=260",
            "1/26=346", "read 1/30", "1/31=0", "1/33=0", "read 1/40", "1/41=0", "1/42=0", "1/43=345", "1/44=259",
            "read 1/50", "1/51=0", "read 1/60", "1/61=0", "1/62=0", "9/1=80640"),
            from("read 1/10", fake).subList(0, 31));
        List<String> end = from("5/142=1", fake);
        assertEquals(List.of("5/142=1", "5/143=1", "5/144=0"), end.subList(0, 3));
    }

    @Test
    public void stopsADavisBeforeItsTransfers() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        CameraSource source = started(fake);
        fake.requests.clear();
        source.close();
        source.close();
        source.stop();
        assertEquals(List.of("1/3=0", "2/4=0", "3/2=0", "3/3=0", "3/4=0", "4/0=0", "0/0=0", "0/1=0", "9/0=0", "0/3=0",
            "cancel", "close", "close"), fake.requests);
    }

    @Test
    public void startsAndStopsADvs128() throws EventSourceException {
        FakeTransport fake = FakeTransport.plugged(CameraModel.DVS128);
        CameraSource source = started(fake);
        // 1992 = 0007c8, 1108364 = 10e98c, 16777215 = ffffff, 8159221 = 7c7ff5, 132 = 000084, 309590 = 04b956,
        // 969 = 0003c9, 209996 = 03344c, 13125 = 003345, 271 = 00010f, 217 = 0000d9
        assertEquals(List.of("b4 ", "clear 86",
            "b8 0007c810e98cffffff7c7ff500008404b9560003c9ffffff03344c00334500010f0000d9",
            "transfers 8 x 4096 from 86", "b3 "), from("b4 ", fake));
        // raw (0, 0) ON at 5 µs
        fake.send((byte) 0, (byte) 0, (byte) 5, (byte) 0);
        assertTrue(source.next(batch));
        assertEquals(127, batch.x[0]);
        fake.requests.clear();
        source.close();
        assertEquals(List.of("b4 ", "cancel", "close"), fake.requests);
    }

    @Test
    public void sendsOtherBiases() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        CameraSource source = open(fake);
        source.start(Biases.defaults(source.model()).with("OnBn", "0x1234"));
        assertTrue(fake.requests.contains("5/1=" + 0x1234));
    }

    @Test
    public void deliversWhatCameBeforeItWasStopped() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        CameraSource source = started(fake);
        fake.sendWords(0x8005, 0x1007, 0x2003, 0x2004);
        fake.sendWords(0x3005);
        source.stop();
        assertTrue(source.next(batch));
        assertEquals(2, batch.size());
        assertTrue(source.next(batch));
        assertEquals(1, batch.size());
        assertEquals(5, batch.x[0]);
        assertFalse(source.next(batch));
        assertEquals(0, batch.size());
        assertEquals(2, (long) source.counts().get("transfers"));
    }

    @Test
    public void cutsATransferThatABatchDoesNotHold() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        CameraSource source = started(fake);
        fake.sendWords(0x8005, 0x1007, 0x2001, 0x2002, 0x2003);
        EventBatch small = new EventBatch(2);
        assertTrue(source.next(small));
        assertEquals(1, small.x[0]);
        assertEquals(2, small.size());
        assertTrue(source.next(small));
        assertEquals(3, small.x[0]);
        assertEquals(1, small.size());
    }

    @Test
    public void goesOnAfterALostTransferAndSaysSo() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        CameraSource source = started(fake);
        fake.sendWords(0x8005, 0x1007, 0x2001);
        fake.receiver.lost(UsbConnection.TransferFault.STALL);
        fake.receiver.lost(UsbConnection.TransferFault.OVERFLOW);
        fake.receiver.lost(UsbConnection.TransferFault.OVERFLOW);
        fake.sendWords(0x2002, 0x1008, 0x2003);
        source.stop();
        assertTrue(source.next(batch));
        assertTrue(source.next(batch));
        assertEquals(1, batch.size());
        assertEquals(3, batch.x[0]);
        assertEquals(3, source.packetsLost());
        assertEquals(List.of("[DAVIS240C 00000042] 1 transfer lost by a stall of the endpoint",
            "[DAVIS240C 00000042] 2 transfers lost by more data than asked for"), source.faults());
        assertEquals(1, (long) source.dropped().get("without_row"));
    }

    @Test
    public void givesUpWhereNothingButFaultsComes() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        CameraSource source = started(fake);
        for (int i = 0; i < 100; i++) {
            fake.receiver.lost(UsbConnection.TransferFault.ERROR);
        }
        assertEquals("[DAVIS240C 00000042] 100 transfers in a row were lost, the last by an error on the wire",
            assertThrows(EventSourceException.class, () -> source.next(batch)).getMessage());
    }

    @Test
    public void deliversEverythingBeforeItWasUnplugged() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        CameraSource source = started(fake);
        fake.sendWords(0x8005, 0x1007, 0x2001);
        fake.unplug();
        fake.requests.clear();
        assertTrue(source.next(batch));
        assertEquals("[DAVIS240C 00000042] the camera was unplugged",
            assertThrows(EventSourceException.class, () -> source.next(batch)).getMessage());
        source.close();
        assertEquals("a camera that is gone is not told to stop", List.of("cancel", "close"), fake.requests);
    }

    @Test
    public void dropsWholePacketsOldestFirstWhereTheEngineFallsBehind() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        CameraSource source = started(fake);
        int limit = source.queueLimit();
        for (int i = 0; i < limit + 3; i++) {
            fake.sendWords(0x8000 | i, 0x1000, 0x2000, 0x2001);
        }
        source.stop();
        assertEquals(limit, source.packetsWaiting());
        assertEquals(6, source.eventsDropped());
        assertEquals(6, (long) source.dropped().get("engine_behind"));
        assertTrue(source.next(batch));
        assertEquals(3, batch.timeUs[0]);
    }

    @Test
    public void failsToStartWhereTheCameraDoesNotAnswer() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        CameraSource source = open(fake);
        fake.failingRequest = "5/3=";
        assertEquals("[DAVIS240C 00000042] cannot be started: 5/3=23451 failed (LIBUSB_ERROR_IO)",
            assertThrows(EventSourceException.class, () -> source.start(Biases.defaults(source.model())))
                .getMessage());
        assertNull("no transfers", fake.receiver);
    }
}
