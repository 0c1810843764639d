package io.github.sofas.live;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;

import io.github.sofas.event.EventSourceException;
import java.util.List;
import org.junit.Test;

public class CamerasTest {
    private static final UsbDevice MOUSE = new UsbDevice(0x046D, 0xC077, 0x7200, 1, 3);

    private static String refusal(FakeTransport fake, String serial) {
        return assertThrows(EventSourceException.class, () -> new Cameras(fake, ms -> { }).open(serial)).getMessage();
    }

    @Test
    public void listsCamerasAndNothingElse() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        fake.devices.add(0, MOUSE);
        List<Cameras.Camera> cameras = new Cameras(fake).list();
        assertEquals(1, cameras.size());
        assertEquals("DAVIS240C 00000042", cameras.get(0).name());
        assertNull(cameras.get(0).fault());
        assertEquals("closed again", List.of("open", "close"), fake.requests);
    }

    @Test
    public void saysThatThereIsNoCamera() {
        FakeTransport fake = new FakeTransport();
        fake.devices.add(MOUSE);
        assertEquals("no camera is plugged in; supported are DAVIS240C, DAVIS346 and DVS128", refusal(fake, null));
    }

    @Test
    public void namesTheSerialNumbersThatThereAre() {
        assertEquals("no camera has the serial number \"7\"; there are DAVIS240C 00000042",
            refusal(FakeTransport.davis240c(), "7"));
    }

    @Test
    public void opensTheCameraWithTheSerialNumber() throws EventSourceException {
        assertEquals("DAVIS240C 00000042",
            new Cameras(FakeTransport.davis240c(), ms -> { }).open("00000042").name());
    }

    @Test
    public void namesTheRuleWhereItHasNoPermission() {
        FakeTransport fake = FakeTransport.davis240c();
        fake.openFault = new UsbException(UsbException.Fault.NO_PERMISSION, "it cannot be opened");
        String message = "[DAVIS240C] no permission to open bus 1, address 7: on Linux, copy "
            + "udev/65-event-cameras.rules to /etc/udev/rules.d, run \"udevadm control --reload\" and plug the camera "
            + "in again";
        assertEquals(message, refusal(fake, null));
        assertEquals("it may be the one that was asked for", message, refusal(fake, "7"));
    }

    @Test
    public void saysThatFirmwareIsMissing() {
        FakeTransport fake = new FakeTransport();
        fake.devices.add(new UsbDevice(0x04B4, 0x00F3, 0x0100, 2, 5));
        assertEquals("[camera] firmware missing: bus 2, address 5 is a bare FX3 (04b4:00f3); flash the camera's "
            + "firmware with jAER or the maker's tool", refusal(fake, null));
        fake.devices.set(0, new UsbDevice(0x04B4, 0x8613, 0x0100, 2, 5));
        assertEquals("[camera] firmware missing: bus 2, address 5 is a bare FX2 (04b4:8613); flash the camera's "
            + "firmware with jAER or the maker's tool", refusal(fake, null));
    }

    @Test
    public void takesAReadyCameraBesideOneWithoutFirmware() throws EventSourceException {
        FakeTransport fake = FakeTransport.davis240c();
        fake.devices.add(0, new UsbDevice(0x04B4, 0x00F3, 0x0100, 2, 5));
        assertEquals("DAVIS240C 00000042", new Cameras(fake, ms -> { }).open(null).name());
    }

    @Test
    public void refusesOldFirmware() {
        FakeTransport fake = FakeTransport.davis240c();
        fake.devices.set(0, new UsbDevice(0x152A, 0x841B, 0x0103, 1, 7));
        assertEquals("[DAVIS240C 00000042] the camera's firmware must be version 4 or newer but was 3; update it with "
            + "the maker's tool", refusal(fake, null));
    }

    @Test
    public void refusesOldLogic() {
        FakeTransport fake = FakeTransport.davis240c();
        fake.parameters.put("6/7", 0);
        assertEquals("[DAVIS240C 00000042] the camera's logic must be version 18.1 or newer but was 18.0; update it "
            + "with the maker's tool", refusal(fake, null));
        assertEquals("close", fake.requests.get(fake.requests.size() - 1));
    }

    @Test
    public void refusesAnUnknownChip() {
        FakeTransport fake = FakeTransport.davis240c();
        fake.parameters.put("6/1", 7);
        assertEquals("[DAVIS240C 00000042] unknown chip: its number must be one of {0=DAVIS240A, 1=DAVIS240B, "
            + "2=DAVIS240C} but was 7", refusal(fake, null));
        assertEquals("close", fake.requests.get(fake.requests.size() - 1));
    }

    @Test
    public void refusesAChipWithAnotherNumberOfPixels() {
        FakeTransport fake = FakeTransport.davis240c();
        fake.parameters.put("1/2", 4);
        assertEquals("[DAVIS240C 00000042] a DAVIS240C must have 240x180 pixels but the camera reports 240 columns "
            + "and 180 rows, swapped", refusal(fake, null));
    }

    @Test
    public void saysThatAnotherProgramHasTheCamera() {
        FakeTransport fake = FakeTransport.davis240c();
        fake.claimFault = new UsbException(UsbException.Fault.BUSY, "its interface cannot be claimed");
        assertEquals("[DAVIS240C 00000042] another program uses the camera; close it first", refusal(fake, null));
        assertEquals("close", fake.requests.get(fake.requests.size() - 1));
    }
}
