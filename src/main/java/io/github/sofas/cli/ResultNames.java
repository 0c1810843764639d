package io.github.sofas.cli;

import io.github.sofas.export.TableFormat;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Names of the files that hold the results of a recording.
 *
 * @param out their folder
 * @param name of the results, without their endings
 */
record ResultNames(Path out, String name) {
    /** File with one row per event, as CSV. */
    Path flow() {
        return flow(TableFormat.CSV);
    }

    /** The same in a given format. */
    Path flow(TableFormat format) {
        return ending("flow." + format.extension());
    }

    /** File with the track of each segment. */
    Path tracks(TableFormat format) {
        return ending("tracks." + format.extension());
    }

    /** File with one row per track plane. */
    Path segments() {
        return ending("segments.csv");
    }

    /** File with the figures of the run. */
    Path summary() {
        return ending("summary.json");
    }

    /** File of the report. */
    Path report() {
        return ending("report.html");
    }

    private Path ending(String ending) {
        return out.resolve(name + "." + ending);
    }

    /** All files of a run without a report, the summary last. */
    List<Path> ofRun(List<TableFormat> formats) {
        List<Path> files = new ArrayList<>();
        for (TableFormat format : formats) {
            files.add(flow(format));
            files.add(tracks(format));
        }
        files.add(segments());
        files.add(summary());
        return files;
    }

    /** All files of a live stream, the summary last. */
    List<Path> ofLive() {
        return List.of(flow(), segments(), summary());
    }
}
