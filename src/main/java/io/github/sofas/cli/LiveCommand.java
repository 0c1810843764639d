package io.github.sofas.cli;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.export.RunSummary;
import io.github.sofas.live.Biases;
import io.github.sofas.live.CameraSource;
import io.github.sofas.live.Cameras;
import io.github.sofas.live.JaerUdpSource;
import io.github.sofas.live.LiveSource;
import io.github.sofas.live.Usb4JavaTransport;
import io.github.sofas.live.UsbException;
import io.github.sofas.live.UsbTransport;
import io.github.sofas.recording.Chip;
import io.github.sofas.recording.Printable;
import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * Labels the events of a camera, or of jAER's network stream, with flow and segment as they happen. This class checks
 * the arguments, opens the source and warms up the engine. {@link LiveRun} does the rest.
 */
@Command(name = "live", sortOptions = false,
    customSynopsis = {"sofas live --out DIR [OPTION]...",
        "       sofas live --out DIR --udp PORT --chip CHIP [OPTION]...",
        "       sofas live --list"},
    description = {"Label the events of a camera with flow and segment as they happen.",
        "Reads a DAVIS240C, DAVIS346 or DVS128 on USB, or jAER's AEUnicast stream. Runs until Ctrl-C or for "
        + "--duration, and writes NAME.flow.csv, NAME.segments.csv and NAME.summary.json, as 'run' does."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:stopped by Ctrl-C or --duration", "1:no camera, or the camera failed; the results hold all "
    + "events up to then",
        "2:wrong usage; nothing was run"})
final class LiveCommand implements Callable<Integer> {
    private static final int MAX_PORT = 65_535;

    @Spec
    private CommandSpec spec;

    @Option(names = "--list", description = "List the cameras.")
    private boolean list;

    @Option(names = {"-o", "--out"}, paramLabel = "DIR",
        description = "Output folder; created if it does not exist.")
    private Path out;

    @Option(names = "--name", paramLabel = "NAME", defaultValue = "live",
        description = "NAME of the results; default: ${DEFAULT-VALUE}.")
    private String name;

    @Option(names = {"-f", "--force"}, description = "Replace existing results; otherwise they are an error.")
    private boolean force;

    @Option(names = "--duration", paramLabel = "SECONDS", description = "Duration; default: until Ctrl-C.")
    private Double durationS;

    @Option(names = "--delay", paramLabel = "MS",
        description = "Label each event by what comes up to MS ms after it, too, 4 to 10000, and write it a quarter of "
            + "that later; default: at once.")
    private Integer delayMs;

    @Option(names = "--record", paramLabel = "FILE",
        description = "Also record the labelled events, as AEDAT 2.0, which jAER and 'run' can read.")
    private Path record;

    @Option(names = "--serial", paramLabel = "NUMBER",
        description = "Serial number of the camera; default: the first camera.")
    private String serial;

    @Option(names = "--biases", paramLabel = "FILE",
        description = "Properties file with biases that replace defaults, such as DiffBn=0x427F or, as coarse and "
        + "fine current of a DAVIS, DiffBn=4 39.")
    private Path biases;

    @Option(names = "--udp", paramLabel = "[HOST:]PORT",
        description = "Read jAER's AEUnicast stream (usual port: 8991) instead of a camera. Listens on 127.0.0.1 "
        + "(this machine only) unless a host is given; 0.0.0.0 accepts all.")
    private String udp;

    @Option(names = "--chip", paramLabel = "CHIP", description = "Sensor of the stream read by --udp.")
    private String chip;

    @Option(names = {"-q", "--quiet"}, description = "Print only errors and warnings, no status and no summary.")
    private boolean quiet;

    @Mixin
    private MethodOptions methodOptions;

    @Mixin
    private ParameterOptions parameterOptions;

    @Override
    public Integer call() throws InterruptedException {
        PrintWriter err = spec.commandLine().getErr();
        try {
            if (list) {
                return list();
            }
            MethodChoice method = check();
            return udp != null ? runNetwork(method) : runCamera(method);
        } catch (EventSourceException e) {
            err.println(e.getMessage());
        } catch (UsbException e) {
            err.println("USB cannot be used: " + e.getMessage());
        } catch (IOException e) {
            err.println(Printable.of("[" + out + "] results cannot be written: " + FileFailure.text(e)));
        }
        return Main.FAILED;
    }

    private Integer list() throws UsbException, EventSourceException {
        try (UsbTransport usb = new Usb4JavaTransport()) {
            List<Cameras.Camera> cameras = new Cameras(usb).list();
            PrintWriter to = spec.commandLine().getOut();
            for (Cameras.Camera camera : cameras) {
                to.println(String.format(Locale.ROOT, "%-10s serial %-12s bus %d address %d  %s",
                    camera.model() == null ? "unknown" : camera.model(),
                    camera.serial().isEmpty() ? "unknown" : camera.serial(), camera.device().bus(),
                    camera.device().address(), camera.fault() == null ? "ready" : camera.fault()));
            }
            if (cameras.isEmpty()) {
                to.println("no camera is plugged in");
            }
            return Main.OK;
        }
    }

    /** Checks everything that can be wrong before the source is opened, and returns the method. */
    private MethodChoice check() {
        if (out == null) {
            throw usage("Missing required option: '--out=DIR'");
        }
        if (durationS != null && !(durationS > 0)) {
            throw usage("--duration must be positive but was " + durationS);
        }
        if (udp == null && chip != null) {
            throw usage("--chip is for --udp; a camera reports its own chip");
        }
        if (udp != null && (serial != null || biases != null)) {
            throw usage((serial != null ? "--serial" : "--biases") + " is for a camera and cannot be combined with "
            + "--udp");
        }
        MethodChoice method = methodOptions.choice(parameterOptions);
        if (delayMs != null) {
            method = LookAheadOptions.withLookAhead(method, parameterOptions.parameters(), "--delay", delayMs, spec);
        }
        if (!name.equals(String.valueOf(Path.of(name).getFileName())) || name.equals(".") || name.equals("..")
                || name.isEmpty()) {
            throw usage("--name must be the name of a file, without folders, but was \"" + name + "\"");
        }
        OutputFiles outputs = new OutputFiles(spec.commandLine());
        List<Path> files = new ArrayList<>(new ResultNames(out, name).ofLive());
        files.add(record);
        outputs.check(Arrays.asList(biases, parameterOptions.config()), files);
        if (!force) {
            outputs.refuseExisting(files);
        }
        outputs.makeFolder(out);
        offerWhatIsLeft(files);
        return method;
    }

    /** Reports the files of killed runs, which still have temporary names. They hold all but the last second. */
    private void offerWhatIsLeft(List<Path> files) {
        files.stream().filter(Objects::nonNull).map(file -> file.toAbsolutePath().getParent()).distinct()
            .flatMap(folder -> ResultFiles.leftBehind(folder).stream())
            .forEach(left -> spec.commandLine().getErr().println(Printable.of("[" + left + "] was left by a run that "
                + "was killed: " + left.toFile().length() + " bytes; give it another name to keep it, or delete it")));
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }

    private int runNetwork(MethodChoice method) throws EventSourceException, IOException {
        if (chip == null) {
            throw usage("--udp needs --chip, one of " + Chip.knownNames());
        }
        Chip sender = Chip.named(chip).orElseThrow(() ->
            usage("--chip must be one of " + Chip.knownNames() + " but was \"" + chip + "\""));
        InetSocketAddress address = address();
        WarmUp.run(sender.sensor(), method);
        try (LiveSource source = new JaerUdpSource(address, sender)) {
            return run(source, method, () -> { });
        }
    }

    private InetSocketAddress address() {
        int colon = udp.lastIndexOf(':');
        int port = -1;
        try {
            port = Integer.parseInt(udp.substring(colon + 1));
        } catch (NumberFormatException e) {
            // The port stays outside the range.
            port = -1;
        }
        if (port < 1 || port > MAX_PORT) {
            throw usage("--udp must be a port from 1 to " + MAX_PORT + ", or host:port, but was \"" + udp + "\"");
        }
        InetSocketAddress address = colon < 0 ? new InetSocketAddress(InetAddress.getLoopbackAddress(), port)
            : new InetSocketAddress(udp.substring(0, colon), port);
        if (address.isUnresolved()) {
            throw usage("--udp names an unknown host: \"" + udp.substring(0, colon) + "\"");
        }
        return address;
    }

    private int runCamera(MethodChoice method) throws EventSourceException, UsbException, IOException {
        ConfigFile changes = biases == null ? null : readBiases();
        try (UsbTransport usb = new Usb4JavaTransport(); CameraSource source = new Cameras(usb).open(serial)) {
            Biases chosen = biases(source, changes);
            WarmUp.run(source.sensor(), method);
            return run(source, method, () -> source.start(chosen));
        }
    }

    private ConfigFile readBiases() {
        try {
            return ConfigFile.read(biases);
        } catch (IllegalArgumentException e) {
            throw usage(e.getMessage());
        }
    }

    private Biases biases(CameraSource source, ConfigFile changes) {
        Biases defaults = Biases.defaults(source.model());
        try {
            return changes == null ? defaults : changed(defaults, changes);
        } catch (IllegalArgumentException e) {
            throw usage(e.getMessage());
        }
    }

    /**
     * Returns biases with the changes that a file asks for.
     *
     * @throws IllegalArgumentException if the file names an unknown bias or a value out of range
     */
    static Biases changed(Biases defaults, ConfigFile changes) {
        Biases changed = defaults;
        for (String key : changes.keys()) {
            try {
                changed = changed.with(key, changes.value(key));
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException(changes.place(key) + e.getMessage(), e);
            }
        }
        return changed;
    }

    private int run(LiveSource source, MethodChoice method, LiveRun.Start start)
            throws EventSourceException, IOException {
        PrintWriter err = spec.commandLine().getErr();
        LiveStatus status = new LiveStatus(source, err, RunProgress.standardErrorIsTerminal()
            ? spec.usageMessage().width() : Integer.MAX_VALUE, System::nanoTime);
        LiveRun run = new LiveRun(source, method, new ResultNames(out, name), record, force, status);
        DiskWatch disk = new DiskWatch(out.toString(), out.toFile()::getUsableSpace, run::bytesWritten,
            System::nanoTime);
        ScheduledExecutorService clock = Executors.newScheduledThreadPool(1);
        RunOutcome outcome;
        StopSignals signals = StopSignals.handle(source::stop);
        try {
            clock.scheduleAtFixedRate(() -> {
                String warning = disk.warning();
                if (warning != null) {
                    status.warn(warning);
                }
            }, 1, 1, TimeUnit.SECONDS);
            if (!quiet) {
                err.println("[" + source.name() + "] " + source.formatName() + ", " + source.sensor()
                    + " px, labelling" + (durationS == null ? " until Ctrl-C" : ""));
                clock.scheduleAtFixedRate(status::show, 1, 1, TimeUnit.SECONDS);
            }
            outcome = run.run(() -> {
                start.start();
                status.started();
                if (durationS != null) {
                    clock.schedule(source::stop, Math.round(durationS * 1e9), TimeUnit.NANOSECONDS);
                }
            });
        } finally {
            signals.close();
            clock.shutdownNow();
        }
        outcome.summary().recording().faults().forEach(err::println);
        if (source.eventsDropped() > 0) {
            err.println("[" + source.name() + "] " + source.eventsDropped()
                + " events were dropped because labelling fell behind");
        }
        if (!quiet) {
            summarise(outcome.summary(), status, err);
        }
        return outcome.damage() == null ? Main.OK : Main.FAILED;
    }

    private void summarise(RunSummary summary, LiveStatus status, PrintWriter err) {
        err.println(String.format(Locale.ROOT, "%s: %d events in %.2f s, %.1f %% with flow, %d %s; %s", name,
            summary.recording().events(), summary.seconds().wall(), 100 * summary.shareWithFlow(),
            summary.countLarge(), summary.countLarge() == 1 ? "segment" : "segments", status.latency()));
    }
}
