package io.github.sofas.cli;

import io.github.sofas.export.TableFormat;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import picocli.CommandLine.Option;

/** How the results of recordings are written, for the commands that label many. */
final class ResultOptions {
    @Option(names = "--format", paramLabel = "FORMAT", split = ",", defaultValue = "csv",
        description = "Formats of NAME.flow and NAME.tracks: csv, parquet, npz, or some of them; default: "
            + "${DEFAULT-VALUE}.")
    private List<String> formatNames;

    @Option(names = {"-f", "--force"}, description = "Replace existing results; otherwise they are an error.")
    private boolean force;

    @Option(names = "--resume",
        description = "Continue an interrupted batch: skip recordings with complete results of the same recording, "
        + "parameters and version.")
    private boolean resume;

    @Option(names = "--name-with-extension",
        description = "Keep the extension in NAME, for recordings that differ only in it.")
    private boolean nameWithExtension;

    /**
     * The formats of the tables, each once, in the order of the enum.
     *
     * @throws IllegalArgumentException where one is unknown, with a message for the user
     */
    List<TableFormat> formats() {
        Set<TableFormat> formats = EnumSet.noneOf(TableFormat.class);
        for (String name : formatNames) {
            formats.add(TableFormat.named(name).orElseThrow(() -> new IllegalArgumentException("--format must be csv, "
                + "parquet or npz but was " + name + (name.equalsIgnoreCase("hdf5") ? ", which no library for Java "
                + "writes in pieces; in Python, h5py makes it of an npz" : ""))));
        }
        return List.copyOf(formats);
    }

    /** Whether results that exist are replaced. */
    boolean replaces() {
        return force;
    }

    /** Whether what is complete is passed over. */
    boolean resumes() {
        return resume;
    }

    /** Whether results keep the extension of their recording. */
    boolean keepsExtension() {
        return nameWithExtension;
    }
}
