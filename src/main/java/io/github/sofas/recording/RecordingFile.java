package io.github.sofas.recording;

import io.jhdf.HdfFile;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * The bytes of a file, read through one buffer that decoders index themselves. {@code buffer[position]} is the next
 * byte, {@code buffer[limit]} the first byte that is not loaded yet.
 */
final class RecordingFile implements Closeable {
    /** Large enough that a read costs little per event, small enough to stay in the second-level cache. */
    static final int BUFFER_BYTES = 128 * 1024;

    /** The file's name, as messages show it. */
    final String name;
    final byte[] buffer = new byte[BUFFER_BYTES];
    int position;
    int limit;

    private final FileChannel channel;
    private final ByteBuffer view = ByteBuffer.wrap(buffer);
    private final long sizeAtFirst;
    private final boolean isSeekable;
    private long bufferOffset;

    RecordingFile(Path path) throws IOException {
        name = Printable.of(path.getFileName() == null ? path.toString() : path.getFileName().toString());
        channel = FileChannel.open(path, StandardOpenOption.READ);
        sizeAtFirst = channel.size();
        isSeekable = Files.isRegularFile(path);
    }

    /** Where in the file the next byte lies. */
    long offset() {
        return bufferOffset + position;
    }

    /** How many bytes the file has now. */
    long size() throws IOException {
        return channel.size();
    }

    /** How many bytes the file had when it was opened; 0 for a stream, which is no file. */
    long sizeAtFirst() {
        return sizeAtFirst;
    }

    /** Whether any place of the file can be read, which is not so for a stream. */
    boolean isSeekable() {
        return isSeekable;
    }

    /** How many bytes are buffered. */
    int available() {
        return limit - position;
    }

    /**
     * Reads on until this many bytes are buffered.
     *
     * @param bytes at most {@link #BUFFER_BYTES}
     * @return false where the file ends before; the rest of the file is then buffered
     */
    boolean require(int bytes) throws IOException {
        if (limit - position >= bytes) {
            return true;
        }
        System.arraycopy(buffer, position, buffer, 0, limit - position);
        bufferOffset += position;
        limit -= position;
        position = 0;
        while (limit < bytes) {
            view.limit(buffer.length).position(limit);
            int read = channel.read(view);
            if (read < 0) {
                return false;
            }
            limit += read;
        }
        return true;
    }

    /**
     * Copies bytes into an array; large amounts bypass the buffer.
     *
     * @return how many bytes were copied, fewer than asked for only at the file's end
     */
    int read(byte[] target, int from, int bytes) throws IOException {
        int done = Math.min(bytes, limit - position);
        System.arraycopy(buffer, position, target, from, done);
        position += done;
        while (done < bytes) {
            if (bytes - done < BUFFER_BYTES) {
                boolean whole = require(bytes - done);
                int rest = Math.min(bytes - done, limit - position);
                System.arraycopy(buffer, position, target, from + done, rest);
                position += rest;
                return whole ? bytes : done + rest;
            }
            bufferOffset += limit;
            position = 0;
            limit = 0;
            int read = channel.read(ByteBuffer.wrap(target, from + done, bytes - done));
            if (read < 0) {
                return done;
            }
            bufferOffset += read;
            done += read;
        }
        return done;
    }

    /** The file's last bytes as text; the position does not change. */
    String tail(int bytes) throws IOException {
        ByteBuffer tail = ByteBuffer.allocate((int) Math.min(bytes, size()));
        long from = size() - tail.capacity();
        while (tail.hasRemaining() && channel.read(tail, from + tail.position()) > 0) {
            // a channel may return less than it has
            continue;
        }
        return new String(tail.array(), 0, tail.position(), StandardCharsets.UTF_8);
    }

    /**
     * The file as HDF5, read without the buffer; closing one closes both.
     *
     * @throws io.jhdf.exceptions.HdfException where the file is not HDF5
     */
    HdfFile asHdf5() {
        return new HdfFile(channel);
    }

    /** Goes to a place in the file, forwards or backwards. */
    void seek(long offset) throws IOException {
        if (offset >= bufferOffset && offset <= bufferOffset + limit) {
            position = (int) (offset - bufferOffset);
            return;
        }
        channel.position(offset);
        bufferOffset = offset;
        position = 0;
        limit = 0;
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
