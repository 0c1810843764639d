package io.github.sofas.cli;

import io.github.sofas.export.TableFormat;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Which files have the results of a recording.
 *
 * @param out their folder
 * @param name of the results, without their endings
 */
record ResultNames(Path out, String name) {
    /** Where the row of every event goes. */
    Path flow() {
        return flow(TableFormat.CSV);
    }

    /** The same in any format. */
    Path flow(TableFormat format) {
        return ending("flow." + format.extension());
    }

    /** Where each segment's way goes. */
    Path tracks(TableFormat format) {
        return ending("tracks." + format.extension());
    }

    /** Where the track planes go. */
    Path segments() {
        return ending("segments.csv");
    }

    /** Where the figures of the run go. */
    Path summary() {
        return ending("summary.json");
    }

    /** Where the report goes. */
    Path report() {
        return ending("report.html");
    }

    private Path ending(String ending) {
        return out.resolve(name + "." + ending);
    }

    /** All that a run without a report writes, the summary last. */
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

    /** All that a live stream leaves, the summary last. */
    List<Path> ofLive() {
        return List.of(flow(), segments(), summary());
    }
}
