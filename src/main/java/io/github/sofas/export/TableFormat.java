package io.github.sofas.export;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** A format that tables are written in. */
public enum TableFormat {
    /** Text with commas, for everything. */
    CSV,
    /** Apache Parquet with Zstandard, for pandas, polars, DuckDB and Spark. */
    PARQUET,
    /** An array for each column, for NumPy. */
    NPZ;

    /**
     * {@return the format of a name such as parquet, in upper or lower case}
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

    /** {@return the ending of its files' names} */
    public String extension() {
        return name().toLowerCase(Locale.ROOT);
    }

    /**
     * Starts a file.
     *
     * @param metadata what is said of the table, by name; CSV has no place for it
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
