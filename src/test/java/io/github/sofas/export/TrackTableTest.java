package io.github.sofas.export;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class TrackTableTest {
    private static final String HEADER = "t_us,segment,x,y,min_x,min_y,max_x,max_y,vx_px_per_s,vy_px_per_s,"
        + "turn_rad_per_s,growth_per_s,events";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private final EventBatch batch = new EventBatch(16);
    private final FlowOutput flow = new FlowOutput(16);

    private void add(long timeUs, int x, int y, float vx, float vy, int segment) {
        int i = batch.size();
        batch.add(timeUs, x, y, 1);
        flow.vxPxPerS[i] = vx;
        flow.vyPxPerS[i] = vy;
        flow.segment[i] = segment;
    }

    private List<String> rows() throws IOException {
        Path file = folder.getRoot().toPath().resolve("a.tracks.csv");
        try (ResultFiles results = new ResultFiles(true)) {
            try (TrackTable table = TrackTable.open(TableFormat.CSV, results, file, Map.of())) {
                table.add(batch, flow);
            }
            results.commit();
        }
        List<String> lines = Files.readAllLines(file);
        assertEquals(HEADER, lines.get(0));
        return lines.subList(1, lines.size());
    }

    @Test
    public void givesCentreBoxAndMeanVelocityOfEachSegmentAndStep() throws IOException {
        add(-10, 10, 20, 5, -1, 2);
        add(0, 10, 20, 5, -1, 2);
        add(9_999, 30, 26, 7, -3, 2);
        add(9_999, 1, 1, 0, 0, 0);
        add(9_999, 40, 40, 1, 1, 1);
        add(20_000, 12, 20, 5, -1, 2);
        List<String> rows = rows();
        assertEquals("-10000,2,10.000,20.000,10,20,10,20,5.000,-1.000,,,1", rows.get(0));
        assertEquals("0,1,40.000,40.000,40,40,40,40,1.000,1.000,,,1", rows.get(1));
        // the events lie (10, 3) to both sides of the centre and are (1, -1) px/s faster or slower than the mean:
        // turn (10 * -1 - 3 * 1) / 109, growth (10 * 1 + 3 * -1) / 109
        assertEquals("0,2,20.000,23.000,10,20,30,26,6.000,-2.000,"
            + "-0.119,0.064,2", rows.get(2));
        assertEquals("20000,2,12.000,20.000,12,20,12,20,5.000,-1.000,,,1", rows.get(3));
        assertEquals(4, rows.size());
    }

    /** v = (3, 4) + 2 (-y, x) + 0.5 (x, y) about (50, 60), on the corners of a square of 20 px. */
    @Test
    public void findsTurnAndGrowth() throws IOException {
        for (int[] corner : new int[][] {{-10, -10}, {10, -10}, {-10, 10}, {10, 10}}) {
            int x = corner[0];
            int y = corner[1];
            add(5, 50 + x, 60 + y, 3 - 2 * y + 0.5f * x, 4 + 2 * x + 0.5f * y, 7);
        }
        assertEquals(List.of("0,7,50.000,60.000,40,50,60,70,3.000,4.000,2.000,0.500,4"), rows());
    }
}
