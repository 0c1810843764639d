package io.github.sofas.recording;

import com.google.flatbuffers.Table;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * A table of a FlatBuffer, read field by field through its vtable. A field is named by its place in the vtable. Every
 * read is bounded by the given bytes: a table that points outside throws IndexOutOfBoundsException.
 */
final class FlatTable extends Table {
    private FlatTable(ByteBuffer buffer, int position) {
        __reset(position, buffer);
    }

    /**
     * The root table.
     *
     * @param rootAt place of the root's offset
     * @param length how many of the bytes belong to the buffer
     */
    static FlatTable root(byte[] bytes, int rootAt, int length) {
        ByteBuffer buffer = ByteBuffer.wrap(bytes, 0, length).order(ByteOrder.LITTLE_ENDIAN);
        return new FlatTable(buffer, rootAt + buffer.getInt(rootAt));
    }

    /** Whether the identifier stands at a place. */
    static boolean hasIdentifier(byte[] bytes, int at, int length, String identifier) {
        return length - at >= identifier.length()
                && identifier.equals(new String(bytes, at, identifier.length(), StandardCharsets.US_ASCII));
    }

    int intField(int field, int absent) {
        int offset = __offset(field);
        return offset == 0 ? absent : bb.getInt(bb_pos + offset);
    }

    int shortField(int field) {
        int offset = __offset(field);
        return offset == 0 ? 0 : bb.getShort(bb_pos + offset);
    }

    int byteField(int field) {
        int offset = __offset(field);
        return offset == 0 ? 0 : bb.get(bb_pos + offset);
    }

    long longField(int field, long absent) {
        int offset = __offset(field);
        return offset == 0 ? absent : bb.getLong(bb_pos + offset);
    }

    /** An int inside a struct; 0 where the struct is absent. */
    int structInt(int field, int at) {
        int offset = __offset(field);
        return offset == 0 ? 0 : bb.getInt(bb_pos + offset + at);
    }

    /** A text; null where it is absent. */
    String text(int field) {
        int offset = __offset(field);
        if (offset == 0) {
            return null;
        }
        int at = bb_pos + offset + bb.getInt(bb_pos + offset);
        byte[] bytes = new byte[Math.max(0, Math.min(bb.getInt(at), bb.limit() - at - 4))];
        bb.get(at + 4, bytes);
        return new String(bytes, StandardCharsets.UTF_8);
    }

    /** Where a vector's entries start; 0 where it is absent. */
    int vectorAt(int field) {
        int offset = __offset(field);
        return offset == 0 ? 0 : bb_pos + offset + bb.getInt(bb_pos + offset) + 4;
    }

    /** How many entries a vector announces; 0 where it is absent. */
    int vectorLength(int field) {
        int at = vectorAt(field);
        return at == 0 ? 0 : bb.getInt(at - 4);
    }

    /** The table that an entry of a vector of tables points at. */
    FlatTable tableAt(int entryAt) {
        return new FlatTable(bb, entryAt + bb.getInt(entryAt));
    }
}
