package io.github.sofas.benchmark;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.Test;

public class BenchmarkReportTest {
    private static final Machine MACHINE = new Machine("a core", 2, 8_000_000_000L, "Linux 6.1 amd64", "a VM 17",
        List.of("-Xmx1g"), 1_000_000_000L, 0.25);

    private static RecordingFigures figures() {
        Map<Stage, Double> shares = new EnumMap<>(Stage.class);
        shares.put(Stage.RE_CENTRING, 0.75);
        shares.put(Stage.FLOW_PLANE, 0.25);
        PacketTimes packets = new PacketTimes(new Latency(3, 1, 2, 3, 4), new Latency(2, 5_000_000, 6, 7, 8),
            new Latency(2, 9, 10, 11, 12));
        return new RecordingFigures("bar.aedat", "AEDAT 2.0", rates(1, 0xe), rates(5, 0xe), rates(2, 0xd),
            rates(3, 0xc), rates(4, 0xf), shares,
            new EngineFigures(new SensorSize(240, 180), 0.5, 12.5, 1.5, 2_000_000, packets), 3_000_000);
    }

    /** Five runs of 10 events whose middle one takes so many µs, a quarter of it the processor's. */
    private static Rates rates(int us, long checksum) {
        long ns = us * 1000L;
        return Rates.of(10, new long[] {ns, ns, ns, ns / 2, ns * 2}, new long[] {ns / 4}, checksum);
    }

    @Test
    public void jsonHoldsMachineAndRecordings() throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        new BenchmarkReport(MACHINE, List.of(figures())).write(out);
        String dense = out.toString(StandardCharsets.UTF_8).replaceAll("\\s*\n\\s*", "").replace("\" : ", "\":");
        assertEquals("{\"machine\":{\"cpu\":\"a core\",\"cores\":2,\"memory_bytes\":8000000000,"
            + "\"os\":\"Linux 6.1 amd64\",\"jvm\":\"a VM 17\",\"jvm_options\":[\"-Xmx1g\"],"
            + "\"max_heap_bytes\":1000000000,\"load\":0.25},"
            + "\"recordings\":[{\"recording\":\"bar.aedat\",\"format\":\"AEDAT 2.0\",\"width\":240,\"height\":180,"
            + "\"events\":10,"
            + "\"engine\":{\"runs\":5,\"min_events_per_s\":5000000.0,\"median_events_per_s\":10000000.0,"
            + "\"max_events_per_s\":20000000.0,\"median_ns_per_event\":100.000,"
            + "\"median_cpu_ns_per_event\":25.000,\"checksum\":\"000000000000000e\","
            + "\"share_with_flow\":0.500000,\"events_per_px\":12.5,"
            + "\"allocated_bytes_per_event\":1.5000,\"held_bytes\":2000000,"
            + "\"latency_1_ms\":{\"packets\":3,\"p50_ns\":1,\"p99_ns\":2,\"p999_ns\":3,\"max_ns\":4},"
            + "\"latency_paced\":{\"packets\":2,\"p50_ns\":5000000,\"p99_ns\":6,\"p999_ns\":7,\"max_ns\":8},"
            + "\"latency_paced_work\":{\"packets\":2,\"p50_ns\":9,\"p99_ns\":10,\"p999_ns\":11,\"max_ns\":12}},"
            + "\"engine_helped\":{\"runs\":5,\"min_events_per_s\":1000000.0,\"median_events_per_s\":2000000.0,"
            + "\"max_events_per_s\":4000000.0,\"median_ns_per_event\":500.000,"
            + "\"median_cpu_ns_per_event\":125.000,\"checksum\":\"000000000000000e\"},"
            + "\"decode\":{\"runs\":5,\"min_events_per_s\":2500000.0,\"median_events_per_s\":5000000.0,"
            + "\"max_events_per_s\":10000000.0,\"median_ns_per_event\":200.000,"
            + "\"median_cpu_ns_per_event\":50.000,\"checksum\":\"000000000000000d\"},"
            + "\"csv\":{\"runs\":5,\"min_events_per_s\":1666666.7,\"median_events_per_s\":3333333.3,"
            + "\"max_events_per_s\":6666666.7,\"median_ns_per_event\":300.000,"
            + "\"median_cpu_ns_per_event\":75.000,\"checksum\":\"000000000000000c\"},"
            + "\"run\":{\"runs\":5,\"min_events_per_s\":1250000.0,\"median_events_per_s\":2500000.0,"
            + "\"max_events_per_s\":5000000.0,\"median_ns_per_event\":400.000,"
            + "\"median_cpu_ns_per_event\":100.000,\"checksum\":\"000000000000000f\","
            + "\"shares\":{\"re_centring\":0.7500,\"flow_plane\":0.2500},\"peak_heap_bytes\":3000000}}]}", dense);
    }

    @Test
    public void plotIsAPictureAlsoOfRecordingsWithoutDensity() throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        new BenchmarkReport(MACHINE, List.of(figures(), figures())).plot(out);
        assertEquals(1440, ImageIO.read(new ByteArrayInputStream(out.toByteArray())).getWidth());
        out.reset();
        new BenchmarkReport(MACHINE, List.of()).plot(out);
        assertEquals(1440, ImageIO.read(new ByteArrayInputStream(out.toByteArray())).getWidth());
    }

    @Test
    public void textNamesMachineAndVirtualMachine() {
        assertEquals("machine  a core, 2 cores, 8.0 GB; Linux 6.1 amd64; load 0.3\n"
            + "jvm      a VM 17; -Xmx1g; heap up to 1000 MB\n", BenchmarkReport.text(MACHINE));
    }

    @Test
    public void textHasALineForEachFigure() {
        assertEquals("bar.aedat: AEDAT 2.0, 240x180, 10 events, 50.0 % with flow; 5 runs\n"
            + "  events/s            minimum       median      maximum   ns/event of the CPU  checksum\n"
            + "  engine              5000000     10000000     20000000      100.0       25.0  000000000000000e\n"
            + "  engine, helped      1000000      2000000      4000000      500.0      125.0  000000000000000e\n"
            + "  decode              2500000      5000000     10000000      200.0       50.0  000000000000000d\n"
            + "  CSV                 1666667      3333333      6666667      300.0       75.0  000000000000000c\n"
            + "  whole run           1250000      2500000      5000000      400.0      100.0  000000000000000f\n"
            + "  time           re-centring 75.0 %, flow plane 25.0 %\n"
            + "  packets, ms                      packets       p50       p99     p99.9   longest\n"
            + "  1 ms of the recording                  3     0.000     0.000     0.000     0.000\n"
            + "  1000 events, one each ms               2     5.000     0.000     0.000     0.000\n"
            + "  of which worked on                     2     0.000     0.000     0.000     0.000\n"
            + "  density        13 events with flow while what they show travels 1 px\n"
            + "  memory         1.500 bytes allocated per event, engine holds 2.0 MB, "
            + "peak heap of a whole run 3.0 MB\n",
            BenchmarkReport.text(figures()));
    }
}
