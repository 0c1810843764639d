package io.github.sofas.cli;

import io.github.sofas.batch.BatchColumn;
import io.github.sofas.batch.BatchOrder;
import io.github.sofas.batch.BatchRow;
import io.github.sofas.batch.BatchTask;
import io.github.sofas.batch.Storage;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.TableFormat;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Labels one recording of a batch. The command {@code run} works in a folder of its own, and the results move to their
 * places when all are complete. An old summary is deleted before that and the new one comes last, so that a summary
 * shows that the other results are complete.
 */
final class BatchLabelling {
    private final BatchOrder order;
    private final BatchTask task;
    private final BatchPlaces places;
    private final BatchRow row;

    /**
     * Creates the labelling of one recording.
     *
     * @param remote storage of the files that are not on this machine
     */
    BatchLabelling(BatchOrder order, BatchTask task, Storage remote) {
        this.order = order;
        this.task = task;
        places = new BatchPlaces(remote);
        row = new BatchRow(task);
    }

    /** Labels the recording and returns its row of the table, in which a failure is noted. */
    BatchRow label() throws InterruptedException {
        Path work = null;
        Path named = Path.of(task.recording().name());
        try {
            work = workFolder();
            label(work);
        } catch (IOException | EventSourceException | RuntimeException | OutOfMemoryError e) {
            if (e instanceof ClosedByInterruptException || Thread.currentThread().isInterrupted()) {
                throw new InterruptedException("told to stop");
            }
            row.failed(text(named, e));
        } finally {
            if (work != null) {
                delete(work);
            }
        }
        return row;
    }

    private static String text(Path recording, Throwable failure) {
        if (failure instanceof OutOfMemoryError) {
            return "[" + recording + "] out of memory: Java's heap has " + (Runtime.getRuntime().maxMemory() >> 20)
                + " MB; spark.executor.memory, or spark.driver.memory in local mode, would give it more";
        }
        String known = RunFailure.text(recording, failure);
        if (known == null) {
            failure.printStackTrace();
            return "[" + recording + "] unexpected error: " + failure;
        }
        return known;
    }

    /**
     * Creates the folder of the run: beside the results if they are on this machine, so that renaming moves them to
     * their places.
     */
    private Path workFolder() throws IOException {
        if (BatchPlaces.isRemote(order.staging())) {
            return Files.createTempDirectory("sofas-batch");
        }
        return Files.createTempDirectory(Files.createDirectories(Path.of(order.staging())), "task");
    }

    /** Deletes the folder. In the staging folder of a batch, files that remain are deleted with that. */
    private static void delete(Path work) {
        try {
            new LocalStorage().delete(work.toString());
        } catch (IOException e) {
            System.err.println("[" + work + "] cannot be deleted: " + FileFailure.text(e));
        }
    }

    private void label(Path work) throws IOException, EventSourceException, InterruptedException {
        String place = task.recording().place();
        boolean isHere = !BatchPlaces.isRemote(place);
        Path recording = isHere ? Path.of(place)
            : Files.createDirectory(work.resolve("recording")).resolve(task.recording().name());
        RunCommand command = RunCommand.parsed(order.options(), recording, work);
        RecordingRun run = command.runs(Map.of(task.name(), recording)).get(0).of(task.recording().shownAs());
        Map<Path, String> targets = targets(run);
        String summary = targets.get(run.names().summary());
        if (order.resumes() && isDone(run, targets, summary, work)) {
            return;
        }
        if (!isHere) {
            fetch(place, recording);
        }
        run.run(new RunProgress(new PrintWriter(OutputStream.nullOutputStream()), true, null), command.threads());
        EarlierRun written = EarlierRun.of(run.names().summary());
        places.at(summary).delete(summary);
        for (Map.Entry<Path, String> target : targets.entrySet()) {
            places.at(target.getValue()).put(target.getKey(), target.getValue(), order.staging());
        }
        enter(written, false);
    }

    private void fetch(String place, Path recording) throws IOException, EventSourceException {
        try {
            places.at(place).fetch(place, recording, Long.MAX_VALUE);
            // a resumed batch recognises the results by this time
            Files.setLastModifiedTime(recording, FileTime.fromMillis(task.recording().changedMs()));
        } catch (IOException e) {
            throw new EventSourceException("[" + recording.getFileName() + "] cannot be fetched: "
                + FileFailure.text(e), e);
        }
    }

    /** Final place of each file of the run, in the order of the files. */
    private Map<Path, String> targets(RecordingRun run) {
        Map<Path, String> targets = new LinkedHashMap<>();
        for (Path file : run.files()) {
            targets.put(file, BatchPlaces.in(order.out(), file.getFileName().toString()));
        }
        if (order.events() != null) {
            String partition = BatchPlaces.partition(order.events(), run.names().name());
            targets.replace(run.names().flow(TableFormat.PARQUET), BatchPlaces.in(partition, "events.parquet"));
        }
        return targets;
    }

    /** Whether an earlier batch or run has made the same results. If so, enters its figures in the row. */
    private boolean isDone(RecordingRun run, Map<Path, String> targets, String summary, Path work)
            throws IOException {
        if (places.at(summary).bytes(summary) < 0) {
            return false;
        }
        Path copy = work.resolve("earlier.json");
        places.at(summary).fetch(summary, copy, Long.MAX_VALUE);
        EarlierRun earlier = EarlierRun.of(copy);
        Map<String, Long> bytes = new LinkedHashMap<>();
        for (Map.Entry<Path, String> target : targets.entrySet()) {
            long size = places.at(target.getValue()).bytes(target.getValue());
            bytes.put(target.getKey().getFileName().toString(), Math.max(0, size));
        }
        String request = run.request(task.recording().bytes(), task.recording().changedMs());
        if (earlier == null || earlier.whyNot(request, bytes) != null) {
            return false;
        }
        enter(earlier, true);
        return true;
    }

    private void enter(EarlierRun results, boolean isEarlier) {
        Map<String, String> values = results.values();
        for (BatchColumn column : BatchColumn.values()) {
            if (column.pointer() != null && values.containsKey(column.pointer())) {
                row.setText(column, values.get(column.pointer()));
            }
        }
        String faults = String.join("; ", under("/recording/faults/", values).values());
        row.set(BatchColumn.OUTCOME, results.complete() ? BatchRow.COMPLETE : BatchRow.DAMAGED)
            .set(BatchColumn.EARLIER, isEarlier)
            .set(BatchColumn.FAULT, faults.isEmpty() ? null : faults)
            .set(BatchColumn.PARAMETERS, under("/parameters/", values).entrySet().stream()
                .map(each -> each.getKey() + "=" + each.getValue()).collect(Collectors.joining(" ")))
            .set(BatchColumn.EVENTS_DROPPED, sum(under("/events_dropped/", values).values().stream()
                .map(Long::valueOf).toList()))
            .set(BatchColumn.RESULT_BYTES, sum(List.copyOf(results.fileBytes().values())));
    }

    private static long sum(List<Long> numbers) {
        return numbers.stream().mapToLong(Long::longValue).sum();
    }

    private static Map<String, String> under(String pointer, Map<String, String> values) {
        Map<String, String> found = new LinkedHashMap<>();
        values.forEach((path, value) -> {
            if (path.startsWith(pointer)) {
                found.put(path.substring(pointer.length()), value);
            }
        });
        return found;
    }
}
