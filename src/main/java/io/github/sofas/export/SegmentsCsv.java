package io.github.sofas.export;

import io.github.sofas.flow.Segment;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/**
 * Writes one row for every track plane, sorted by id: {@value #HEADER}. Velocities have the form of those in
 * {@link FlowCsvWriter}. {@code merged_into} is empty unless the fate is {@code merged}.
 */
public final class SegmentsCsv {
    /** The first line, without its line end. */
    public static final String HEADER = "segment,first_t_us,last_t_us,events,vx_px_per_s,vy_px_per_s,"
        + "min_x,min_y,max_x,max_y,fate,merged_into,turn_rad_per_s,growth_per_s";

    /**
     * Room per row; no row is longer: six numbers of at most 11 characters, three of 20, four velocities of 17, fate,
     * separators.
     */
    private static final int ROW_LIMIT = 256;

    private SegmentsCsv() {
    }

    /**
     * Writes the header and the rows, and leaves the stream open.
     *
     * @param out receives the text; left open
     * @param segments in any order; none is given twice
     * @throws IOException if the rows cannot be written
     */
    public static void write(OutputStream out, List<Segment> segments) throws IOException {
        List<Segment> sorted = new ArrayList<>(segments);
        sorted.sort(Comparator.comparingInt(Segment::id));
        CsvBuffer buffer = new CsvBuffer(out);
        buffer.put(HEADER);
        buffer.put('\n');
        for (Segment segment : sorted) {
            buffer.makeRoom(ROW_LIMIT);
            buffer.putWithComma(segment.id());
            buffer.put(segment.firstTimeUs());
            buffer.put(',');
            buffer.put(segment.lastTimeUs());
            buffer.put(',');
            buffer.put(segment.events());
            buffer.put(',');
            buffer.putVelocity(segment.vxPxPerS());
            buffer.put(',');
            buffer.putVelocity(segment.vyPxPerS());
            buffer.put(',');
            buffer.putWithComma(segment.minX());
            buffer.putWithComma(segment.minY());
            buffer.putWithComma(segment.maxX());
            buffer.putWithComma(segment.maxY());
            buffer.put(segment.fate().name().toLowerCase(Locale.ROOT));
            buffer.put(',');
            if (segment.fate() == Segment.Fate.MERGED) {
                buffer.put((long) segment.mergedInto());
            }
            buffer.put(',');
            buffer.putVelocity(segment.turnRadPerS());
            buffer.put(',');
            buffer.putVelocity(segment.growthPerS());
            buffer.put('\n');
        }
        buffer.flush();
    }
}
