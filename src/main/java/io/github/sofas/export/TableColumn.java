package io.github.sofas.export;

/**
 * A column of a table.
 *
 * @param name name of the column, with its unit
 * @param type type of its numbers
 */
record TableColumn(String name, Type type) {
    /** The type of the numbers in a column, in memory and in files. */
    enum Type {
        /** Whole numbers of 64 bits, in a {@code long[]}. */
        INT64(Long.BYTES, "<i8"),
        /** Whole numbers of 32 bits, in an {@code int[]}. */
        INT32(Integer.BYTES, "<i4"),
        /** Whole numbers of 16 bits, in a {@code short[]}. */
        INT16(Short.BYTES, "<i2"),
        /** Whole numbers of 8 bits, in a {@code byte[]}. */
        INT8(Byte.BYTES, "|i1"),
        /** Floating-point numbers of 32 bits, in a {@code float[]}; NaN if there is no number. */
        FLOAT32(Float.BYTES, "<f4");

        /** Size of a number in bytes. */
        final int bytes;
        /** Name of the type in NumPy. */
        final String numpy;

        Type(int bytes, String numpy) {
            this.bytes = bytes;
            this.numpy = numpy;
        }
    }
}
