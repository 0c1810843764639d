package io.github.sofas.export;

import static org.junit.Assert.assertEquals;

import io.github.sofas.flow.Segment;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.Test;

public class SegmentsCsvTest {
    private static final String HEADER = "segment,first_t_us,last_t_us,events,vx_px_per_s,vy_px_per_s,"
        + "min_x,min_y,max_x,max_y,fate,merged_into,turn_rad_per_s,growth_per_s\n";

    private static Segment segment(int id, Segment.Fate fate, int mergedInto) {
        return new Segment(id, -5, 1_000_000, 12_345, 58.0005f, -72.5f, 0.25f, -1.5f, 0, 10, 239, 179, fate,
            mergedInto);
    }

    private static String written(List<Segment> segments) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        SegmentsCsv.write(out, segments);
        return out.toString(StandardCharsets.US_ASCII);
    }

    @Test
    public void writesTheHeaderAloneWithoutSegments() throws IOException {
        assertEquals(HEADER, written(List.of()));
    }

    @Test
    public void writesARowForEachFateSortedById() throws IOException {
        // 58.0005f is 58.000499725...: rounded down.
        String figures = ",-5,1000000,12345,58.000,-72.500,0,10,239,179,";
        assertEquals(HEADER + "2" + figures + "alive,,0.250,-1.500\n3" + figures + "merged,2,0.250,-1.500\n5000"
            + figures + "removed,,0.250,-1.500\n",
            written(List.of(segment(5000, Segment.Fate.REMOVED, 0), segment(2, Segment.Fate.ALIVE, 0),
                segment(3, Segment.Fate.MERGED, 2))));
    }

    @Test
    public void writesTheSameBytesInTurkish() throws IOException {
        Locale before = Locale.getDefault();
        try {
            // Where the lower case of I is a dotless i.
            Locale.setDefault(Locale.forLanguageTag("tr-TR"));
            assertEquals(HEADER + "1,-5,1000000,12345,58.000,-72.500,0,10,239,179,alive,,0.250,-1.500\n",
                written(List.of(segment(1, Segment.Fate.ALIVE, 0))));
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    public void writesMoreRowsThanItsBufferHolds() throws IOException {
        List<Segment> many = new ArrayList<>();
        StringBuilder expected = new StringBuilder(HEADER);
        for (int id = 1; id <= 5000; id++) {
            many.add(segment(id, Segment.Fate.REMOVED, 0));
            expected.append(id).append(",-5,1000000,12345,58.000,-72.500,0,10,239,179,removed,,0.250,-1.500\n");
        }
        assertEquals(expected.toString(), written(many));
    }
}
