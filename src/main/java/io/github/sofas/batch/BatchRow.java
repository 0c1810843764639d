package io.github.sofas.batch;

import java.io.Serializable;
import java.util.EnumMap;
import java.util.Map;

/** What became of one recording of a batch. */
public final class BatchRow implements Serializable {
    /** The outcome of a recording that was read to its end. */
    public static final String COMPLETE = "complete";
    /** The outcome of a recording that has results up to a damage. */
    public static final String DAMAGED = "damaged";
    /** The outcome of a recording without results. */
    public static final String FAILED = "failed";

    private static final long serialVersionUID = 1L;

    private final EnumMap<BatchColumn, Object> values = new EnumMap<>(BatchColumn.class);

    /**
     * Begins a row.
     *
     * @param task whose recording it is of
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
     * @param column where
     * @param value of the column's type; null for nothing
     * @return this
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
     * Enters a value of a column that the summary has, from its text there.
     *
     * @param column where
     * @param text empty for nothing
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
     * Notes that there are no results.
     *
     * @param fault why, for the user
     * @return this
     */
    public BatchRow failed(String fault) {
        return set(BatchColumn.OUTCOME, FAILED).set(BatchColumn.FAULT, fault);
    }

    /**
     * {@return a value; null where there is none}
     *
     * @param column where
     */
    public Object get(BatchColumn column) {
        return values.get(column);
    }

    /**
     * {@return a text; empty where there is none}
     *
     * @param column where
     */
    public String text(BatchColumn column) {
        Object value = get(column);
        return value == null ? "" : value.toString();
    }

    /**
     * {@return a number; 0 where there is none}
     *
     * @param column where
     */
    public double number(BatchColumn column) {
        Object value = get(column);
        return value == null ? 0 : ((Number) value).doubleValue();
    }

    /** {@return what was entered} */
    public Map<BatchColumn, Object> values() {
        return Map.copyOf(values);
    }
}
