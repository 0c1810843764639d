#!/usr/bin/python3
"""A DAVIS or DVS128 that is not there.

Runs a program that sees a camera on the USB, whose bulk endpoint sends the bytes of a file at a steady rate once it has
been told to run. Debian's umockdev stands in for the files below /sys and /dev; every ioctl of usbfs that the program
makes on the device ends up here.

    camera_model.py CONFIG.json PROGRAM ARGUMENT...

CONFIG: vendor, product, release, serial; parameters {"module/number": value} that can be read; stream (file),
repeat (how often it is sent), bytes_per_s; faults [{"transfer": n, "kind": stall|error|overflow|unplug}], n from 1 of
those that carry data; deny (to be opened by others than root), busy (refuse to be claimed); log (file that takes every
request); first (run before all other programs, for a camera does not wait for a processor; needs the right to).
"""
import ctypes
import errno
import fcntl
import json
import os
import shutil
import signal
import struct
import subprocess
import sys
import time

import gi

gi.require_version("UMockdev", "1.0")
from gi.repository import GLib, UMockdev  # noqa: E402

# linux/usbdevice_fs.h
RESET, CLEAR_HALT = 0x5514, 0x80045515
SUBMIT, DISCARD, REAP, REAP_NO_DELAY = 0x8038550A, 0x550B, 0x4008550C, 0x4008550D
CLAIM, RELEASE, SET_CONFIGURATION = 0x8004550F, 0x80045510, 0x80045505
GET_DRIVER, GET_CAPABILITIES, DISCONNECT_CLAIM = 0x41045508, 0x8004551A, 0x8108551B
CAPABILITIES = 0x01 | 0x04 | 0x10  # zero packet, no packet size limit, reap after disconnect
URB_BYTES = 56
BUFFER_AT, LENGTH_AT, ACTUAL_AT, STATUS_AT = 16, 24, 28, 4
URB_BULK, URB_CONTROL = 3, 2
SETUP_BYTES = 8

EARLY_S = 0.001  # a camera sends what it has after 1 ms, full packet or not
HELD_MS = 1  # how long a question for what is not there yet is kept; libusb would ask again at once
MOST_IN_A_ROW = 8  # libusb asks until it is told that there is no more, and does nothing else meanwhile

KINDS = {"stall": -errno.EPIPE, "error": -errno.EPROTO, "overflow": -errno.EOVERFLOW}


class Camera(UMockdev.IoctlBase):
    def __init__(self, config):
        super().__init__()
        self.config = config
        self.parameters = config.get("parameters", {})
        self.log = open(config["log"], "w") if config.get("log") else None
        with open(config["stream"], "rb") as file:
            self.stream = file.read()
        self.total = len(self.stream) * config.get("repeat", 1)
        self.rate = config["bytes_per_s"]
        self.faults = {fault["transfer"]: fault["kind"] for fault in config.get("faults", [])}
        self.sent = 0
        self.running_since = None
        self.last_data = 0.0
        self.transfers = 0
        self.most_behind = 0
        self.all_sent = False
        self.waiting = []  # submitted bulk URBs
        self.done = []  # URBs that can be reaped
        self.gone = False
        self.halted = False
        self.in_a_row = 0

    def note(self, text):
        if self.log:
            self.log.write(text + "\n")
            self.log.flush()

    # one method an ioctl; each returns (result, errno), or None where the client is kept waiting

    def do_handle_ioctl(self, client):
        try:
            answer = self.ioctl(client, client.get_request())
        except Exception as fault:  # pylint: disable=broad-except
            print("camera model: " + repr(fault), file=sys.stderr)
            answer = (-1, errno.EIO)
        if answer is not None:
            client.complete(*answer)
        return True

    def ioctl(self, client, request):
        argument = client.get_arg()
        if request in (REAP, REAP_NO_DELAY):
            return self.reap(client)
        if request == SUBMIT:
            return self.submit(argument.resolve(0, URB_BYTES))
        if request == DISCARD:
            return self.discard(struct.unpack("<Q", bytes(argument.retrieve()))[0])
        if request == GET_CAPABILITIES:
            argument.resolve(0, 4).update(0, struct.pack("<I", CAPABILITIES))
            return (0, 0)
        if self.gone:
            return (-1, errno.ENODEV)
        if request in (CLAIM, DISCONNECT_CLAIM):
            self.note("claim")
            return (-1, errno.EBUSY) if self.config.get("busy") else (0, 0)
        if request == CLEAR_HALT:
            endpoint = struct.unpack("<I", bytes(argument.resolve(0, 4).retrieve()))[0]
            self.note("clear halt %02x" % endpoint)
            self.halted = False
            return (0, 0)
        if request == RELEASE:
            self.note("release")
            return (0, 0)
        if request in (SET_CONFIGURATION, RESET):
            return (0, 0)
        if request == GET_DRIVER:
            return (-1, errno.ENODATA)
        return (-1, errno.ENOTTY)

    def submit(self, urb):
        if self.gone:
            return (-1, errno.ENODEV)
        fields = bytes(urb.retrieve())
        length = struct.unpack_from("<i", fields, LENGTH_AT)[0]
        buffer = urb.resolve(BUFFER_AT, length)
        if fields[0] == URB_CONTROL:
            status, actual = self.control(buffer, length)
            self.finish(urb, status, actual)
        elif fields[0] == URB_BULK:
            self.waiting.append((urb, buffer, length))
        else:
            return (-1, errno.EINVAL)
        return (0, 0)

    def control(self, buffer, length):
        data = bytes(buffer.retrieve())
        kind, request, value, index, size = struct.unpack_from("<BBHHH", data)
        payload = data[SETUP_BYTES:SETUP_BYTES + size]
        if kind == 0x80 and request == 6:
            answer = self.string_descriptor(value & 0xFF)[:size]
        elif kind == 0xC0:
            key = "%d/%d" % (value, index)
            self.note("read %02x %s" % (request, key))
            answer = struct.pack(">I", self.parameters.get(key, 0))
        elif kind == 0x40:
            self.note("write %02x %d/%d %s" % (request, value, index, payload.hex()))
            self.written(request, value, index, payload)
            return 0, size
        else:
            return -errno.EPIPE, 0
        buffer.update(SETUP_BYTES, answer)
        return 0, len(answer)

    def string_descriptor(self, number):
        if number == 0:
            return b"\x04\x03\x09\x04"
        text = self.config["serial"].encode("utf-16-le")
        return bytes([len(text) + 2, 3]) + text

    def written(self, request, value, index, payload):
        on = any(payload)
        if request == 0xBF and (value, index) == (1, 3):
            self.run(on)
        elif request in (0xB3, 0xB4):
            self.run(request == 0xB3)

    def run(self, on):
        if on and self.running_since is None:
            self.running_since = time.monotonic()
            self.last_data = self.running_since
        elif not on and self.running_since is not None:
            self.total = self.sent
        if self.log:
            self.note("sent %d of the stream in %d transfers" % (self.sent, self.transfers))

    def discard(self, address):
        for i, (urb, _, _) in enumerate(self.waiting):
            if urb.client_addr == address:
                del self.waiting[i]
                self.finish(urb, -errno.ENOENT, 0)
                return (0, 0)
        return (-1, errno.EINVAL)

    def finish(self, urb, status, actual):
        urb.update(STATUS_AT, struct.pack("<i", status))
        urb.update(ACTUAL_AT, struct.pack("<i", actual))
        self.done.append(urb)

    def reap(self, client):
        self.send()
        if self.done and self.in_a_row < MOST_IN_A_ROW:
            self.in_a_row += 1
            if self.sent == self.total and not self.all_sent and self.transfers:
                self.all_sent = True
                self.note("all sent")
            client.get_arg().resolve(0, 8).set_ptr(0, self.done.pop(0))
            return (0, 0)
        self.in_a_row = 0
        if self.done:
            return (-1, errno.EAGAIN)
        GLib.timeout_add(HELD_MS, self.nothing_there, client)
        return None

    def nothing_there(self, client):
        client.complete(-1, errno.ENODEV if self.gone else errno.EAGAIN)
        return False

    def send(self):
        """Puts what the camera has by now into one waiting transfer."""
        if self.running_since is None or self.halted or not self.waiting or self.done:
            return
        now = time.monotonic()
        there = min(self.total, int((now - self.running_since) * self.rate) & ~3) - self.sent
        length = self.waiting[0][2]
        if there <= 0 or there < length and now - self.last_data < EARLY_S:
            return
        self.most_behind = max(self.most_behind, there)
        self.last_data = now
        self.transfers += 1
        kind = self.faults.get(self.transfers)
        if kind == "unplug":
            self.unplug()
            return
        urb, buffer, _ = self.waiting.pop(0)
        actual = min(there, length)
        if kind:
            self.note("%s at transfer %d, bytes %d to %d" % (kind, self.transfers, self.sent, self.sent + actual))
            self.sent += actual
            self.halted = kind == "stall"
            self.finish(urb, KINDS[kind], 0)
            return
        at = self.sent % len(self.stream)
        chunk = self.stream[at:at + actual]
        while len(chunk) < actual:
            chunk += self.stream[:actual - len(chunk)]
        buffer.update(0, chunk)
        self.sent += actual
        self.finish(urb, 0, actual)

    def unplug(self):
        self.note("unplugged, sent %d" % self.sent)
        self.gone = True
        for urb, _, _ in self.waiting:
            self.finish(urb, -errno.ENODEV, 0)
        self.waiting = []


def device_descriptor(config):
    return struct.pack("<BBHBBBBHHHBBBB", 18, 1, 0x0200, 0, 0, 0, 64, config["vendor"], config["product"],
                       config["release"], 0, 0, 1, 1)


def configuration_descriptor():
    endpoints = b"".join(struct.pack("<BBBBHB", 7, 5, address, 2, 512, 0) for address in (0x82, 0x86))
    interface = struct.pack("<BBBBBBBBB", 9, 4, 0, 0, 2, 0xFF, 0, 0, 0)
    total = 9 + len(interface) + len(endpoints)
    return struct.pack("<BBHBBBBB", 9, 2, total, 1, 1, 0, 0x80, 250) + interface + endpoints


def plug_in(testbed, config):
    descriptors = device_descriptor(config) + configuration_descriptor()
    path = "/sys/devices/pci0000:00/0000:00:01.0/usb1/1-1"
    testbed.add_from_string("\n".join([
        "P: " + path[len("/sys"):],
        "N: bus/usb/001/007=" + descriptors.hex().upper(),
        "E: SUBSYSTEM=usb", "E: DEVTYPE=usb_device", "E: DEVNAME=/dev/bus/usb/001/007", "E: BUSNUM=001",
        "E: DEVNUM=007", "A: busnum=1\\n", "A: devnum=7\\n", "A: bConfigurationValue=1\\n", "A: speed=480\\n",
        "H: descriptors=" + descriptors.hex().upper(), ""]))


def die_with_parent():
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)


def be_a_program():
    die_with_parent()
    os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        config = json.load(file)
    die_with_parent()
    if config.get("first"):
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(50))
    testbed = UMockdev.Testbed.new()
    root = testbed.get_root_dir()
    loop = GLib.MainLoop()
    camera = Camera(config)
    try:
        if config.get("plugged_in", True):
            plug_in(testbed, config)
            if config.get("deny"):
                os.chmod(os.path.join(root, "dev/bus/usb/001/007"), 0)
            testbed.attach_ioctl("/dev/bus/usb/001/007", camera)
        environment = dict(os.environ, UMOCKDEV_DIR=root, LD_PRELOAD="libumockdev-preload.so.0")
        child = subprocess.Popen(sys.argv[2:], env=environment, preexec_fn=be_a_program)
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda which, frame: child.send_signal(which))

        def look():
            if child.poll() is not None:
                loop.quit()
                return False
            return True
        GLib.timeout_add(20, look)
        loop.run()
        camera.note("most bytes behind: %d" % camera.most_behind)
        code = child.returncode
    finally:
        # The testbed removes its folder itself where it is let go, but not what is in it where it is not.
        for name in os.listdir(root):
            shutil.rmtree(os.path.join(root, name), ignore_errors=True)
    sys.exit(code if code >= 0 else 128 - code)


if __name__ == "__main__":
    main()
