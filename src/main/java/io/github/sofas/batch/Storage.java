package io.github.sofas.batch;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;

/** Access to files by their place: an absolute path on this machine, or a URI. */
public interface Storage {
    /**
     * {@return the names of all entries of a folder; empty if there is no such folder}
     *
     * @param folder place of the folder
     * @throws IOException if the folder cannot be read
     */
    Set<String> names(String folder) throws IOException;

    /**
     * {@return the size of a file in bytes; -1 if there is no such file}
     *
     * @param file place of the file
     * @throws IOException if the size cannot be read
     */
    long bytes(String file) throws IOException;

    /**
     * Copies a file, with its time of change.
     *
     * @param file place of the file
     * @param local the file to copy to
     * @param mostBytes greatest number of bytes to copy
     * @throws IOException if the file cannot be read or the copy cannot be written
     */
    void fetch(String file, Path local, long mostBytes) throws IOException;

    /**
     * Copies the content of a stream to a file, for implementations of {@link #fetch}.
     *
     * @param in the stream, which stays open
     * @param local the file to copy to, replaced if there is one
     * @param mostBytes greatest number of bytes to copy
     * @throws IOException if the stream cannot be read or the copy cannot be written
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
     * Moves or copies a file to its place. At any time, the place holds another file, none, or the whole file, but
     * never a part of it. Makes the folder if it is missing.
     *
     * @param local the file, which may be moved
     * @param file place of the file
     * @param staging a folder for unfinished files
     * @throws IOException if the file cannot be written
     */
    void put(Path local, String file, String staging) throws IOException;

    /**
     * Deletes a file, or a folder with all that it contains, if it exists.
     *
     * @param place place of the file or folder
     * @throws IOException if it cannot be deleted
     */
    void delete(String place) throws IOException;
}
