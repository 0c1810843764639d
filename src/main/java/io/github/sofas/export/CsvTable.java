package io.github.sofas.export;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Writes a table as CSV: a header, then one line per row. Floats have three decimals as in {@link FlowCsvWriter}, and
 * NaN is an empty field. The table of events with flow has a faster writer of its own.
 */
final class CsvTable implements TableWriter {
    /** Room per number: no number with its comma is longer. */
    private static final int NUMBER_LIMIT = 24;

    private final OutputStream out;
    private final CsvBuffer buffer;
    private final List<TableColumn> columns;

    CsvTable(OutputStream out, List<TableColumn> columns) {
        this.out = out;
        this.columns = columns;
        buffer = new CsvBuffer(out);
        buffer.put(columns.stream().map(TableColumn::name).collect(Collectors.joining(",")));
        buffer.put('\n');
    }

    @Override
    public void write(TableRows rows) throws IOException {
        for (int row = 0; row < rows.size(); row++) {
            buffer.makeRoom(NUMBER_LIMIT * columns.size());
            for (int i = 0; i < columns.size(); i++) {
                if (i > 0) {
                    buffer.put(',');
                }
                put(rows, i, row);
            }
            buffer.put('\n');
        }
    }

    private void put(TableRows rows, int column, int row) {
        switch (columns.get(column).type()) {
            case INT64:
                buffer.put(rows.longs(column)[row]);
                break;
            case INT32:
                buffer.put((long) rows.ints(column)[row]);
                break;
            case INT16:
                buffer.put((long) rows.shorts(column)[row]);
                break;
            case INT8:
                buffer.put((long) rows.bytes(column)[row]);
                break;
            default:
                float value = rows.floats(column)[row];
                if (!Float.isNaN(value)) {
                    buffer.putVelocity(value);
                }
                break;
        }
    }

    @Override
    public void close() throws IOException {
        try (out) {
            buffer.flush();
        }
    }
}
