package io.github.sofas.batch;

import java.io.Serializable;
import java.util.EnumMap;
import java.util.Map;

/** The outcome for one recording of a batch: a row of the table that the batch writes, with a value per column. */
public final class BatchRow implements Serializable {
    /** The outcome of a recording that was read to its end. */
    public static final String COMPLETE = "complete";
    /** The outcome of a recording that is damaged and has results up to the damage. */
    public static final String DAMAGED = "damaged";
    /** The outcome of a recording without results. */
    public static final String FAILED = "failed";

    private static final long serialVersionUID = 1L;

    private final EnumMap<BatchColumn, Object> values = new EnumMap<>(BatchColumn.class);

    /**
     * Begins a row, with the columns that are known before the run.
     *
     * @param task the recording of the row
     */
    public BatchRow(BatchTask task) {
        set(BatchColumn.RECORDING, task.recording().shownAs());
        set(BatchColumn.NAME, task.name());
        set(BatchColumn.RECORDING_BYTES, task.recording().bytes());
        set(BatchColumn.EARLIER, false);
    }

    /**
     * Enters a value.
     *
     * @param column column of the value
     * @param value value of the column's type; null for none
     * @return this row
     */
    public BatchRow set(BatchColumn column, Object value) {
        if (value == null) {
            values.remove(column);
        } else {
            values.put(column, column.type().cast(value));
        }
        return this;
    }

    /**
     * Enters a value from its text in the summary.
     *
     * @param column column of the value, one that the summary has
     * @param text the value as text; empty for none
     */
    public void setText(BatchColumn column, String text) {
        if (column.type() == Long.class) {
            set(column, Long.valueOf(text));
        } else if (column.type() == Double.class) {
            set(column, Double.valueOf(text));
        } else if (!text.isEmpty()) {
            set(column, text);
        }
    }

    /**
     * Notes that the recording has no results.
     *
     * @param fault the reason, for the user
     * @return this row
     */
    public BatchRow failed(String fault) {
        return set(BatchColumn.OUTCOME, FAILED).set(BatchColumn.FAULT, fault);
    }

    /**
     * {@return the value of a column; null if there is none}
     *
     * @param column column of the value
     */
    public Object get(BatchColumn column) {
        return values.get(column);
    }

    /**
     * {@return the value of a column as text; empty if there is none}
     *
     * @param column column of the value
     */
    public String text(BatchColumn column) {
        Object value = get(column);
        return value == null ? "" : value.toString();
    }

    /**
     * {@return the value of a column as a number; 0 if there is none}
     *
     * @param column column of the value
     */
    public double number(BatchColumn column) {
        Object value = get(column);
        return value == null ? 0 : ((Number) value).doubleValue();
    }

    /** {@return a copy of all values that were entered} */
    public Map<BatchColumn, Object> values() {
        return Map.copyOf(values);
    }
}
