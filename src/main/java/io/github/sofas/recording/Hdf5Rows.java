package io.github.sofas.recording;

import io.jhdf.api.Dataset;
import io.jhdf.api.dataset.ChunkedDataset;
import io.jhdf.dataset.DatasetBase;
import io.jhdf.exceptions.HdfException;
import io.jhdf.exceptions.UnsupportedHdfException;
import io.jhdf.object.datatype.CompoundDataType;
import io.jhdf.object.datatype.DataType;
import io.jhdf.object.datatype.EnumDataType;
import io.jhdf.object.datatype.FixedPoint;
import io.jhdf.object.datatype.FloatingPoint;
import io.jhdf.object.datatype.OrderedDataType;
import java.nio.ByteBuffer;

/**
 * A data set of an HDF5 file whose first dimension runs over the events. It is read a stretch of rows at a time. A row
 * is one number, several numbers or a structure; a {@link Column} is one number of each row.
 */
final class Hdf5Rows {
    /** Largest accepted chunk; recorders write about 100 kB. */
    private static final long MOST_CHUNK_BYTES = 128L << 20;
    private static final int UNCHUNKED_ROWS = 1 << 16;

    private final DatasetBase dataset;
    private final int[] shape;
    private final int rowBytes;
    private ByteBuffer rows;

    Hdf5Rows(Dataset dataset) {
        this.dataset = (DatasetBase) dataset;
        long[] size = dataset.getDimensionsAsLong();
        if (size.length < 1 || size.length > 2) {
            throw new UnsupportedHdfException("the data set " + dataset.getPath() + " must have one or two dimensions "
                    + "but has " + size.length);
        }
        shape = size.length == 1 ? new int[1] : new int[] {0, Math.toIntExact(size[1])};
        rowBytes = Math.multiplyExact(dataset.getDataType().getSize(), size.length == 1 ? 1 : shape[1]);
    }

    /** How many rows there are. */
    long count() {
        return dataset.getDimensionsAsLong()[0];
    }

    /** How many numbers a row has; 1 where the row is one number or a structure. */
    int width() {
        return shape.length == 1 ? 1 : shape[1];
    }

    /**
     * How many rows to read at once, starting at multiples of this number: the rows of one chunk, so that each chunk is
     * unpacked once.
     *
     * @throws HdfException where a chunk is so large that the file must be damaged
     */
    int stretch() {
        if (!(dataset instanceof ChunkedDataset)) {
            return UNCHUNKED_ROWS;
        }
        int[] chunk = ((ChunkedDataset) dataset).getChunkDimensions();
        long bytes = dataset.getDataType().getSize();
        for (int side : chunk) {
            bytes *= side;
            if (side < 1 || bytes > MOST_CHUNK_BYTES) {
                throw new HdfException("a chunk of the data set " + dataset.getPath() + " must have at most "
                        + MOST_CHUNK_BYTES + " bytes");
            }
        }
        return chunk[0];
    }

    /** Reads a stretch of rows, which replaces the stretch read before. */
    void read(long from, int count) {
        shape[0] = count;
        rows = dataset.getSliceDataBuffer(shape.length == 1 ? new long[] {from} : new long[] {from, 0}, shape);
        if (rows.remaining() < (long) count * rowBytes) {
            throw new HdfException("the data set " + dataset.getPath() + " ends early");
        }
    }

    /** The i-th number of each row, or the row itself where it is one number. */
    Column column(int i) {
        DataType type = dataset.getDataType();
        return new Column(i * type.getSize(), type);
    }

    /**
     * The member with this name in the structure of each row.
     *
     * @throws HdfException where there is none
     */
    Column member(String name) {
        if (dataset.getDataType() instanceof CompoundDataType) {
            for (CompoundDataType.CompoundDataMember member
                    : ((CompoundDataType) dataset.getDataType()).getMembers()) {
                if (member.getName().equals(name)) {
                    return new Column(member.getOffset(), member.getDataType());
                }
            }
        }
        throw new HdfException("the data set " + dataset.getPath() + " must have the member " + name);
    }

    /** One number of each row. */
    final class Column {
        private final int at;
        private final int bytes;
        private final boolean isReal;
        private final boolean isSigned;
        private final OrderedDataType type;

        private Column(int at, DataType given) {
            DataType number = given instanceof EnumDataType ? ((EnumDataType) given).getBaseType() : given;
            isReal = number instanceof FloatingPoint;
            isSigned = number instanceof FixedPoint && ((FixedPoint) number).isSigned();
            bytes = number.getSize();
            boolean isServed = isReal ? bytes == Float.BYTES || bytes == Double.BYTES
                    : number instanceof FixedPoint && Integer.bitCount(bytes) == 1 && bytes <= Long.BYTES;
            if (!isServed) {
                throw new UnsupportedHdfException("the data set " + dataset.getPath() + " must hold numbers of 1, 2, 4 "
                        + "or 8 bytes");
            }
            this.at = at;
            type = (OrderedDataType) number;
        }

        /** Whether the column holds floating-point numbers. */
        boolean isReal() {
            return isReal;
        }

        /** The data set that the column belongs to. */
        Hdf5Rows rows() {
            return Hdf5Rows.this;
        }

        /**
         * Copies the column out of the rows read. Floating-point numbers are rounded; numbers of 8 bytes are copied as
         * they are, whatever their sign.
         */
        void copyTo(long[] target, int from, int count) {
            ByteBuffer buffer = rows.order(type.getByteOrder());
            int p = rows.position() + from * rowBytes + at;
            int i = 0;
            if (isReal) {
                for (; i < count; i++, p += rowBytes) {
                    target[i] = Math.round(bytes == Float.BYTES ? buffer.getFloat(p) : buffer.getDouble(p));
                }
                return;
            }
            switch (bytes) {
                case Byte.BYTES:
                    for (; i < count; i++, p += rowBytes) {
                        target[i] = isSigned ? buffer.get(p) : buffer.get(p) & 0xFF;
                    }
                    break;
                case Short.BYTES:
                    for (; i < count; i++, p += rowBytes) {
                        target[i] = isSigned ? buffer.getShort(p) : buffer.getShort(p) & 0xFFFF;
                    }
                    break;
                case Integer.BYTES:
                    for (; i < count; i++, p += rowBytes) {
                        target[i] = isSigned ? buffer.getInt(p) : buffer.getInt(p) & 0xFFFFFFFFL;
                    }
                    break;
                default:
                    for (; i < count; i++, p += rowBytes) {
                        target[i] = buffer.getLong(p);
                    }
                    break;
            }
        }

        /** Copies floating-point numbers, multiplied and rounded to whole numbers. */
        void copyScaledTo(long[] target, int from, int count, double factor) {
            ByteBuffer buffer = rows.order(type.getByteOrder());
            int p = rows.position() + from * rowBytes + at;
            for (int i = 0; i < count; i++, p += rowBytes) {
                target[i] = Math.round((bytes == Float.BYTES ? buffer.getFloat(p) : buffer.getDouble(p)) * factor);
            }
        }
    }
}
