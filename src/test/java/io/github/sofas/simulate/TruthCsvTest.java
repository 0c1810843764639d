package io.github.sofas.simulate;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.EventBatch;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.Test;

public class TruthCsvTest {
    @Test
    public void writesARowForEveryEventAndLeavesTheVelocityOfNoiseEmpty() throws IOException {
        EventBatch batch = new EventBatch(3);
        Truth truth = new Truth(3);
        batch.add(5, 1, 2, 1);
        truth.vxPxPerS[0] = 58;
        truth.vyPxPerS[0] = -0.25f;
        truth.object[0] = 3;
        batch.add(7, 239, 179, -1);
        batch.add(5_000_000_000L, 0, 0, -1);
        truth.vxPxPerS[2] = -0.0001f;
        truth.vyPxPerS[2] = 1234.5679f;
        truth.object[2] = 1;
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (TruthCsv csv = new TruthCsv(bytes)) {
            csv.write(batch, truth);
        }
        assertEquals("t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,object\n"
                + "5,1,2,1,58.000,-0.250,3\n"
                + "7,239,179,-1,,,0\n"
                + "5000000000,0,0,-1,0.000,1234.568,1\n", bytes.toString(StandardCharsets.US_ASCII));
    }
}
