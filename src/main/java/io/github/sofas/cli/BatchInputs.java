package io.github.sofas.cli;

import io.github.sofas.batch.Cluster;
import io.github.sofas.batch.StoredFile;
import io.github.sofas.recording.Recordings;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Finds the recordings that the arguments of a batch name, by the rules of {@code run}. The files are on this machine
 * or on storage of the cluster.
 */
final class BatchInputs {
    /** Number of bytes at the beginning of a text file that show whether it is a recording. */
    private static final long HEAD_BYTES = 1 << 16;

    private final Cluster cluster;
    private final BatchPlaces places;

    BatchInputs(Cluster cluster, BatchPlaces places) {
        this.cluster = cluster;
        this.places = places;
    }

    /** Reads the arguments in a file: one per line; empty lines are skipped. */
    List<String> lines(String file) throws IOException {
        String place = cluster.qualified(file);
        if (places.at(place).bytes(place) < 0) {
            throw new IllegalArgumentException("[" + file + "] no such file");
        }
        Path copy = Files.createTempFile("sofas-list", ".txt");
        try {
            places.at(place).fetch(place, copy, Long.MAX_VALUE);
            return Files.readAllLines(copy).stream().map(String::strip).filter(line -> !line.isEmpty()).toList();
        } finally {
            Files.delete(copy);
        }
    }

    /**
     * Expands arguments in their order; each file is listed once.
     *
     * @return the files by their places, written as paths
     * @throws IllegalArgumentException if an argument matches no recording; the message is for the user
     */
    Map<String, StoredFile> expand(List<String> arguments) throws IOException {
        Map<String, StoredFile> found = new LinkedHashMap<>();
        for (String argument : arguments) {
            String place = cluster.qualified(argument);
            for (StoredFile file : BatchPlaces.isRemote(place) ? elsewhere(argument, place) : here(argument, place)) {
                found.putIfAbsent(Path.of(file.place()).toString(), file);
            }
        }
        return found;
    }

    private static List<StoredFile> here(String argument, String place) {
        List<StoredFile> files = new ArrayList<>();
        String typed = argument.startsWith("file:") ? place : argument;
        for (Path path : RecordingArguments.expand(List.of(typed))) {
            files.add(new StoredFile(path.toAbsolutePath().normalize().toString(), path.toString(),
                path.toFile().length(), path.toFile().lastModified()));
        }
        return files;
    }

    private List<StoredFile> elsewhere(String argument, String place) throws IOException {
        List<StoredFile> all = cluster.find(place);
        if (!all.isEmpty() && (all.get(0).place().equals(place) || RecordingArguments.isPattern(argument))) {
            return all;
        }
        List<StoredFile> recordings = new ArrayList<>();
        for (StoredFile file : all) {
            if (RecordingArguments.looksLikeRecording(file.name(), () -> isText(file))) {
                recordings.add(file);
            }
        }
        if (recordings.isEmpty()) {
            throw new IllegalArgumentException("[" + argument + "] no recording there: extensions are "
                + String.join(", ", RecordingArguments.EXTENSIONS));
        }
        return recordings;
    }

    private boolean isText(StoredFile file) {
        try {
            Path head = Files.createTempFile("sofas-head", "-" + file.name());
            try {
                places.at(file.place()).fetch(file.place(), head, HEAD_BYTES);
                return Recordings.isText(head);
            } finally {
                Files.delete(head);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
