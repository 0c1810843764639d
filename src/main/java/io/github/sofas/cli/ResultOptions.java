package io.github.sofas.cli;

import io.github.sofas.export.TableFormat;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import picocli.CommandLine.Option;

/**
 * Options of commands that label many recordings: formats and names of the results, and what happens to existing ones.
 */
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
     * @throws IllegalArgumentException if one is unknown; the message is for the user
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

    /** Whether existing results are replaced. */
    boolean replaces() {
        return force;
    }

    /** Whether recordings with complete results are skipped. */
    boolean resumes() {
        return resume;
    }

    /** Whether the names of results keep the extension of their recording. */
    boolean keepsExtension() {
        return nameWithExtension;
    }
}
