package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.FlowOutput;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads the rows that {@link FlowCsvWriter} wrote, events with their labels. Holds one buffer. */
public final class FlowCsvReader implements Closeable {
    private static final int BUFFER = 1 << 16;
    private static final int MOST_DIGITS = 18;
    private static final double[] POWERS = new double[MOST_DIGITS + 1];
    /** Times up to here are exact as floating-point numbers; they are 285 years. */
    private static final long MOST_US = 1L << 53;

    static {
        POWERS[0] = 1;
        for (int i = 1; i < POWERS.length; i++) {
            POWERS[i] = POWERS[i - 1] * 10;
        }
    }

    private final String name;
    private final InputStream in;
    private final byte[] buffer = new byte[BUFFER];
    private int position;
    private int limit;
    private long line = 1;
    private EventSourceException damage;
    // of the number read last
    private int digits;
    private int decimals;

    private FlowCsvReader(String name, InputStream in) {
        this.name = name;
        this.in = in;
    }

    /**
     * Opens a file.
     *
     * @throws EventSourceException where it cannot be read, or begins with another line than {@link FlowCsvWriter}'s
     */
    public static FlowCsvReader open(Path file) throws EventSourceException {
        FlowCsvReader reader;
        try {
            reader = new FlowCsvReader(file.getFileName().toString(), Files.newInputStream(file));
        } catch (IOException e) {
            throw new EventSourceException("[" + file + "] cannot be opened: " + e, e);
        }
        try {
            reader.readHeader();
            return reader;
        } catch (EventSourceException e) {
            reader.close();
            throw e;
        }
    }

    private void readHeader() throws EventSourceException {
        StringBuilder header = new StringBuilder();
        for (int c = take(); c >= 0 && c != '\n' && header.length() < 200; c = take()) {
            header.append(c < ' ' || c > '~' ? '?' : (char) c);
        }
        if (!FlowCsvWriter.HEADER.equals(header.toString())) {
            throw new EventSourceException("[" + name + "] line 1: must be \"" + FlowCsvWriter.HEADER + "\" but was \""
                + header + "\"");
        }
    }

    /**
     * Clears the batch and fills it, and the labels beside it, with the rows that follow.
     *
     * @param flow of the batch's capacity at least
     * @return false at the end
     * @throws EventSourceException where a row is malformed; every row before it was delivered
     */
    public boolean next(EventBatch batch, FlowOutput flow) throws EventSourceException {
        batch.clear();
        try {
            while (damage == null && !batch.isFull() && readRow(batch, flow)) {
                line++;
            }
        } catch (EventSourceException e) {
            damage = e;
        }
        if (batch.size() == 0 && damage != null) {
            throw damage;
        }
        return batch.size() > 0;
    }

    private boolean readRow(EventBatch batch, FlowOutput flow) throws EventSourceException {
        if (position == limit && !fill()) {
            return false;
        }
        int i = batch.size();
        long timeUs = whole("t_us", ',', -MOST_US, MOST_US);
        long x = whole("x", ',', 0, Short.MAX_VALUE);
        long y = whole("y", ',', 0, Short.MAX_VALUE);
        long polarity = whole("polarity", ',', -1, 1);
        if (polarity == 0) {
            throw wrong("polarity", "1 or -1");
        }
        flow.vxPxPerS[i] = (float) number("vx_px_per_s", ',');
        flow.vyPxPerS[i] = (float) number("vy_px_per_s", ',');
        flow.segment[i] = (int) whole("segment", '\n', 0, Integer.MAX_VALUE);
        batch.add(timeUs, (int) x, (int) y, (int) polarity);
        return true;
    }

    private long whole(String column, char end, long least, long most) throws EventSourceException {
        double value = number(column, end);
        if (decimals > 0 || digits == 0 || value < least || value > most) {
            throw wrong(column, "a whole number from " + least + " to " + most);
        }
        return (long) value;
    }

    /** A number up to the end of its field; an empty field is 0. */
    private double number(String column, char end) throws EventSourceException {
        digits = 0;
        decimals = 0;
        long value = 0;
        boolean point = false;
        int c = take();
        boolean negative = c == '-';
        if (negative) {
            c = take();
        }
        while (c != end) {
            if (c == '.' && !point) {
                point = true;
            } else if (c >= '0' && c <= '9' && digits < MOST_DIGITS) {
                value = value * 10 + c - '0';
                digits++;
                decimals += point ? 1 : 0;
            } else {
                throw wrong(column, "a number followed by " + (end == ',' ? "a comma" : "the line's end"));
            }
            c = take();
        }
        double magnitude = value / POWERS[decimals];
        return negative ? -magnitude : magnitude;
    }

    private EventSourceException wrong(String column, String rule) {
        return new EventSourceException("[" + name + "] line " + (line + 1) + ": " + column + " must be " + rule
            + " but was not");
    }

    /** The next byte; -1 at the end. */
    private int take() throws EventSourceException {
        return position < limit || fill() ? buffer[position++] : -1;
    }

    private boolean fill() throws EventSourceException {
        try {
            position = 0;
            limit = Math.max(0, in.read(buffer));
            return limit > 0;
        } catch (IOException e) {
            throw new EventSourceException("[" + name + "] line " + (line + 1) + ": cannot be read: " + e, e);
        }
    }

    @Override
    public void close() {
        try {
            in.close();
        } catch (IOException e) {
            // Nothing was written, so a failure to close loses nothing.
            return;
        }
    }
}
