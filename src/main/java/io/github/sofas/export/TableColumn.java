package io.github.sofas.export;

/**
 * A column of a table.
 *
 * @param name what it is, with its unit
 * @param type of its numbers
 */
record TableColumn(String name, Type type) {
    /** What numbers a column holds. */
    enum Type {
        /** Whole numbers of 64 bits, in a {@code long[]}. */
        INT64(Long.BYTES, "<i8"),
        /** Of 32 bits, in an {@code int[]}. */
        INT32(Integer.BYTES, "<i4"),
        /** Of 16 bits, in a {@code short[]}. */
        INT16(Short.BYTES, "<i2"),
        /** Of 8 bits, in a {@code byte[]}. */
        INT8(Byte.BYTES, "|i1"),
        /** Numbers with a fraction of 32 bits, in a {@code float[]}; NaN where there is none. */
        FLOAT32(Float.BYTES, "<f4");

        /** Size of a number. */
        final int bytes;
        /** How NumPy calls the type. */
        final String numpy;

        Type(int bytes, String numpy) {
            this.bytes = bytes;
            this.numpy = numpy;
        }
    }
}
