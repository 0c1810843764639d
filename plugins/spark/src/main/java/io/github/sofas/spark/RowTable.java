package io.github.sofas.spark;

import io.github.sofas.batch.BatchColumn;
import io.github.sofas.batch.BatchRow;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Map;
import org.apache.parquet.example.data.Group;
import org.apache.parquet.example.data.simple.SimpleGroup;
import org.apache.parquet.hadoop.ParquetWriter;
import org.apache.parquet.hadoop.example.ExampleParquetWriter;
import org.apache.parquet.hadoop.metadata.CompressionCodecName;
import org.apache.parquet.io.LocalOutputFile;
import org.apache.parquet.schema.LogicalTypeAnnotation;
import org.apache.parquet.schema.LogicalTypeAnnotation.TimeUnit;
import org.apache.parquet.schema.MessageType;
import org.apache.parquet.schema.PrimitiveType;
import org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName;
import org.apache.parquet.schema.Types;

/** Writes the rows of a batch as a Parquet file, with the Parquet library that every Spark includes. */
final class RowTable {
    private RowTable() {
    }

    /** Writes the rows to a file that does not exist yet. */
    static void write(List<BatchRow> rows, Path file) throws IOException {
        MessageType schema = schema();
        try (ParquetWriter<Group> writer = ExampleParquetWriter.builder(new LocalOutputFile(file)).withType(schema)
                .withCompressionCodec(CompressionCodecName.ZSTD).build()) {
            for (BatchRow row : rows) {
                Group group = new SimpleGroup(schema);
                for (Map.Entry<BatchColumn, Object> value : row.values().entrySet()) {
                    add(group, value.getKey().columnName(), value.getValue());
                }
                writer.write(group);
            }
        }
    }

    private static MessageType schema() {
        Types.MessageTypeBuilder schema = Types.buildMessage();
        for (BatchColumn column : BatchColumn.values()) {
            schema.addField(field(column.type()).named(column.columnName()));
        }
        return schema.named("recordings");
    }

    private static Types.PrimitiveBuilder<PrimitiveType> field(Class<?> type) {
        if (type == Long.class) {
            return Types.optional(PrimitiveTypeName.INT64);
        } else if (type == Double.class) {
            return Types.optional(PrimitiveTypeName.DOUBLE);
        } else if (type == Boolean.class) {
            return Types.optional(PrimitiveTypeName.BOOLEAN);
        } else if (type == Instant.class) {
            return Types.optional(PrimitiveTypeName.INT64)
                .as(LogicalTypeAnnotation.timestampType(true, TimeUnit.MICROS));
        }
        return Types.optional(PrimitiveTypeName.BINARY).as(LogicalTypeAnnotation.stringType());
    }

    private static void add(Group group, String name, Object value) {
        if (value instanceof Long) {
            group.add(name, (long) value);
        } else if (value instanceof Double) {
            group.add(name, (double) value);
        } else if (value instanceof Boolean) {
            group.add(name, (boolean) value);
        } else if (value instanceof Instant) {
            group.add(name, ChronoUnit.MICROS.between(Instant.EPOCH, (Instant) value));
        } else {
            group.add(name, (String) value);
        }
    }
}
