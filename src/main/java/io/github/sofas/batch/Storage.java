package io.github.sofas.batch;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;

/** Files at places: absolute paths of this machine, or URIs. */
public interface Storage {
    /**
     * {@return the names of what a folder has; empty where there is no folder}
     *
     * @param folder its place
     * @throws IOException where it cannot be looked at
     */
    Set<String> names(String folder) throws IOException;

    /**
     * {@return the size of a file in bytes; -1 where there is none}
     *
     * @param file its place
     * @throws IOException where it cannot be looked at
     */
    long bytes(String file) throws IOException;

    /**
     * Copies a file, with its time of change.
     *
     * @param file its place
     * @param local where it is copied to
     * @param mostBytes how much of it at most
     * @throws IOException where it cannot be read or written
     */
    void fetch(String file, Path local, long mostBytes) throws IOException;

    /**
     * Copies what a stream has to a file, as {@link #fetch} does.
     *
     * @param in the stream, which stays open
     * @param local the file, replaced where there is one
     * @param mostBytes how much of it at most
     * @throws IOException where it cannot be read or written
     */
    static void copy(InputStream in, Path local, long mostBytes) throws IOException {
        try (OutputStream out = Files.newOutputStream(local)) {
            byte[] buffer = new byte[1 << 16];
            long left = mostBytes;
            for (int n = 0; n >= 0 && left > 0; n = in.read(buffer, 0, (int) Math.min(buffer.length, left))) {
                out.write(buffer, 0, n);
                left -= n;
            }
        }
    }

    /**
     * Puts a file in its place, which has another one, none, or all of it, but never a part. Makes the folder where it
     * is missing.
     *
     * @param local the file, which may be moved
     * @param file its place
     * @param staging a folder for what is not whole yet
     * @throws IOException where it cannot be written
     */
    void put(Path local, String file, String staging) throws IOException;

    /**
     * Deletes a file, or a folder with all that is in it, if it is there.
     *
     * @param place of it
     * @throws IOException where it cannot be deleted
     */
    void delete(String place) throws IOException;
}
