package io.github.sofas.live;

import com.fasterxml.jackson.core.JsonEncoding;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import io.github.sofas.Skipped;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/**
 * A camera that is not there, and the program in a Java of its own that sees it: real usb4java and libusb on a USB that
 * Debian's umockdev stands in for. The camera itself is camera_model.py beside this class.
 */
final class ModelledCamera {
    private static final String PYTHON = "/usr/bin/python3";
    /** Set by .ci/run, which installs umockdev: it must be there then. */
    private static final String REQUIRED = "SOFAS_REQUIRE_UMOCKDEV";

    private final Path folder;
    private final Map<String, Integer> parameters = new LinkedHashMap<>();
    private final List<String> faults = new ArrayList<>();
    private CameraModel model = CameraModel.DAVIS240C;
    private UsbDevice device;
    private byte[] stream = new byte[2];
    private int bytesPerS = 1_000_000;
    private boolean busy;
    private Process process;

    /** A DAVIS240C that sends nothing. */
    ModelledCamera(Path folder) {
        this.folder = folder;
        parameters.putAll(Map.of("6/0", 18, "6/7", 1, "6/1", 2, "6/5", 30, "6/6", 1000, "1/0", 240, "1/1", 180));
        is(CameraModel.DAVIS240C);
    }

    /** Skips the test where umockdev is missing, or fails it where it must be there. */
    static void need() throws IOException, InterruptedException {
        Process python = null;
        if (Files.isExecutable(Path.of(PYTHON))) {
            python = new ProcessBuilder(PYTHON, "-c",
                "import gi; gi.require_version('UMockdev', '1.0'); from gi.repository import UMockdev")
                .redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
        }
        if (python == null || python.waitFor() != 0) {
            String missing = "Debian's packages umockdev, gir1.2-umockdev-1.0 and python3-gi are not installed";
            if (System.getenv(REQUIRED) != null) {
                throw new AssertionError(REQUIRED + " is set, but " + missing);
            }
            throw Skipped.because(missing);
        }
    }

    ModelledCamera is(CameraModel newModel) {
        model = newModel;
        device = new UsbDevice(CameraModel.VENDOR_ID, model.productId, model.firmware, 1, 7);
        return this;
    }

    ModelledCamera isDevice(UsbDevice newDevice) {
        device = newDevice;
        return this;
    }

    ModelledCamera tells(String parameter, int value) {
        parameters.put(parameter, value);
        return this;
    }

    ModelledCamera sends(byte[] bytes, int newBytesPerS) {
        stream = bytes;
        bytesPerS = newBytesPerS;
        return this;
    }

    /** One of stall, error, overflow, unplug; transfers with data are counted from 1. */
    ModelledCamera fails(int transfer, String kind) {
        faults.add(kind);
        faults.add(Integer.toString(transfer));
        return this;
    }

    ModelledCamera isBusy() {
        busy = true;
        return this;
    }

    private void writeConfig() throws IOException {
        Files.write(folder.resolve("stream.bin"), stream);
        try (JsonGenerator json = new JsonFactory().createGenerator(folder.resolve("camera.json").toFile(),
                JsonEncoding.UTF8)) {
            json.writeStartObject();
            json.writeNumberField("vendor", device.vendorId());
            json.writeNumberField("product", device.productId());
            json.writeNumberField("release", device.release());
            json.writeStringField("serial", "84010012");
            json.writeStringField("stream", folder.resolve("stream.bin").toString());
            json.writeNumberField("bytes_per_s", bytesPerS);
            json.writeStringField("log", folder.resolve("camera.log").toString());
            json.writeBooleanField("busy", busy);
            json.writeObjectFieldStart("parameters");
            for (Map.Entry<String, Integer> parameter : parameters.entrySet()) {
                json.writeNumberField(parameter.getKey(), parameter.getValue());
            }
            json.writeEndObject();
            json.writeArrayFieldStart("faults");
            for (int i = 0; i < faults.size(); i += 2) {
                json.writeStartObject();
                json.writeStringField("kind", faults.get(i));
                json.writeNumberField("transfer", Integer.parseInt(faults.get(i + 1)));
                json.writeEndObject();
            }
            json.writeEndArray();
            json.writeEndObject();
        }
    }

    /** Starts {@code sofas live} with this camera plugged in. */
    ModelledCamera start(String... arguments) throws Exception {
        writeConfig();
        String script = new File(getClass().getResource("camera_model.py").toURI()).getPath();
        List<String> command = new ArrayList<>(List.of(PYTHON, script, folder.resolve("camera.json").toString(),
            Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xmx128m", "-XX:+UseSerialGC", "-cp",
            System.getProperty("java.class.path"), "io.github.sofas.cli.Main", "live"));
        command.addAll(List.of(arguments));
        process = new ProcessBuilder(command).redirectOutput(folder.resolve("out.txt").toFile())
            .redirectError(folder.resolve("err.txt").toFile()).start();
        return this;
    }

    /** Waits for the program's end. */
    int exitCode() throws Exception {
        if (!process.waitFor(2, TimeUnit.MINUTES)) {
            stop();
            throw new AssertionError("still running after two minutes: " + err());
        }
        return process.exitValue();
    }

    /** Waits until the camera has sent its stream, and ends the program as a service manager does. */
    void terminateWhenAllIsSent() throws Exception {
        while (process.isAlive() && !(Files.exists(folder.resolve("camera.log")) && log().contains("all sent"))) {
            Thread.sleep(20);
        }
        // The model hands the signal on.
        process.destroy();
    }

    void stop() throws InterruptedException {
        if (process != null) {
            process.destroyForcibly().waitFor();
        }
    }

    String out() throws IOException {
        return Files.readString(folder.resolve("out.txt"));
    }

    String err() throws IOException {
        return Files.readString(folder.resolve("err.txt"));
    }

    /** What the camera was asked, in order, and what it did. */
    List<String> log() throws IOException {
        return Files.readAllLines(folder.resolve("camera.log"));
    }
}
