package io.github.sofas.export;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** A file format of tables. */
public enum TableFormat {
    /** Text with commas, for any program. */
    CSV,
    /** Apache Parquet with Zstandard, for pandas, polars, DuckDB and Spark. */
    PARQUET,
    /** An archive with an array for each column, for NumPy. */
    NPZ;

    /**
     * {@return the format with a name such as parquet; empty if there is none}
     *
     * @param name in upper or lower case
     */
    public static Optional<TableFormat> named(String name) {
        for (TableFormat format : values()) {
            if (format.name().equalsIgnoreCase(name.strip())) {
                return Optional.of(format);
            }
        }
        return Optional.empty();
    }

    /** {@return the extension of the names of its files} */
    public String extension() {
        return name().toLowerCase(Locale.ROOT);
    }

    /**
     * Starts a file.
     *
     * @param metadata descriptions of the table, by name; CSV has no place for them
     */
    TableWriter open(ResultFiles results, Path file, List<TableColumn> columns, Map<String, String> metadata)
            throws IOException {
        switch (this) {
            case PARQUET:
                return new ParquetTable(results.create(file), columns, metadata);
            case NPZ:
                return new NpzTable(results.create(file), file.toAbsolutePath().getParent(), columns, metadata);
            default:
                return new CsvTable(results.create(file), columns);
        }
    }
}
