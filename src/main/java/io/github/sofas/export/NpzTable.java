package io.github.sofas.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Map;
import java.util.zip.Deflater;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/**
 * Writes a table as NumPy's {@code .npz}: a zip archive with an array for each column, and one of text for each piece
 * of metadata.
 *
 * <p>An array begins with its length, which is known only at the end. Until then, each column is kept in a file of its
 * own beside the result. These files are deleted when the table is closed.
 *
 * <p>Source: NumPy's {@code numpy.lib.format}, version 1.0.
 */
final class NpzTable implements TableWriter {
    private static final int BUFFER_BYTES = 1 << 16;
    /** The length of magic and header together is a multiple of this number of bytes. */
    private static final int ALIGNMENT = 64;
    private static final byte[] MAGIC = {(byte) 0x93, 'N', 'U', 'M', 'P', 'Y', 1, 0};
    /** Time of all entries: a fixed one, so that the same table gives the same bytes. */
    private static final FileTime MADE = FileTime.fromMillis(315_532_800_000L);

    private final OutputStream out;
    private final List<TableColumn> columns;
    private final Map<String, String> metadata;
    private final FileChannel[] kept;
    private final ByteBuffer buffer = ByteBuffer.allocate(BUFFER_BYTES).order(ByteOrder.LITTLE_ENDIAN);
    private long count;

    /**
     * Starts a table.
     *
     * @param folder folder in which the columns are kept until the end
     */
    NpzTable(OutputStream out, Path folder, List<TableColumn> columns, Map<String, String> metadata)
            throws IOException {
        this.out = out;
        this.columns = columns;
        this.metadata = metadata;
        kept = new FileChannel[columns.size()];
        for (int i = 0; i < kept.length; i++) {
            Path file = Files.createTempFile(folder, ".column", ".part");
            kept[i] = FileChannel.open(file, StandardOpenOption.READ, StandardOpenOption.WRITE,
                StandardOpenOption.DELETE_ON_CLOSE);
        }
    }

    @Override
    public void write(TableRows rows) throws IOException {
        for (int i = 0; i < kept.length; i++) {
            int bytes = columns.get(i).type().bytes;
            for (int from = 0; from < rows.size();) {
                int to = Math.min(rows.size(), from + BUFFER_BYTES / bytes);
                buffer.clear();
                put(rows, i, from, to);
                buffer.flip();
                while (buffer.hasRemaining()) {
                    kept[i].write(buffer);
                }
                from = to;
            }
        }
        count += rows.size();
    }

    private void put(TableRows rows, int column, int from, int to) {
        int length = to - from;
        switch (columns.get(column).type()) {
            case INT64:
                buffer.asLongBuffer().put(rows.longs(column), from, length);
                break;
            case INT32:
                buffer.asIntBuffer().put(rows.ints(column), from, length);
                break;
            case INT16:
                buffer.asShortBuffer().put(rows.shorts(column), from, length);
                break;
            case INT8:
                buffer.put(rows.bytes(column), from, length);
                break;
            default:
                buffer.asFloatBuffer().put(rows.floats(column), from, length);
                break;
        }
        buffer.position(length * columns.get(column).type().bytes);
    }

    @Override
    public void close() throws IOException {
        try (ZipOutputStream zip = new ZipOutputStream(out)) {
            zip.setLevel(Deflater.BEST_SPEED);
            for (int i = 0; i < kept.length; i++) {
                begin(zip, columns.get(i).name(), columns.get(i).type().numpy, "(" + count + ",)");
                kept[i].position(0);
                buffer.clear();
                while (kept[i].read(buffer) > 0) {
                    zip.write(buffer.array(), 0, buffer.position());
                    buffer.clear();
                }
                zip.closeEntry();
            }
            for (Map.Entry<String, String> each : metadata.entrySet()) {
                byte[] text = each.getValue().getBytes(StandardCharsets.UTF_8);
                begin(zip, each.getKey(), "|S" + Math.max(1, text.length), "()");
                zip.write(text.length == 0 ? new byte[1] : text);
                zip.closeEntry();
            }
        } finally {
            for (FileChannel each : kept) {
                each.close();
            }
        }
    }

    private static void begin(ZipOutputStream zip, String name, String type, String shape) throws IOException {
        ZipEntry entry = new ZipEntry(name + ".npy");
        entry.setLastModifiedTime(MADE);
        zip.putNextEntry(entry);
        String header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
        int plain = MAGIC.length + Short.BYTES + header.length() + 1;
        String padded = header + " ".repeat((ALIGNMENT - plain % ALIGNMENT) % ALIGNMENT) + '\n';
        zip.write(MAGIC);
        zip.write(padded.length() & 0xFF);
        zip.write(padded.length() >>> Byte.SIZE);
        zip.write(padded.getBytes(StandardCharsets.US_ASCII));
    }
}
