package io.github.sofas.jaer;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.export.FlowCsvWriter;
import io.github.sofas.export.SegmentsCsv;
import io.github.sofas.export.TrackTable;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.eventprocessing.EventFilter;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** What the filter writes is what the runner would. */
public class SessionLogTest {
    private static final List<EventBatch> FILM = Packets.film();

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path name;
    private SofasFlow filter;

    @Before
    public void begin() {
        EventFilter.PREFERENCES.clear();
        name = folder.getRoot().toPath().resolve("shown");
        AEChip chip = new AEChip();
        chip.sizeX = Packets.SENSOR.width();
        chip.sizeY = Packets.SENSOR.height();
        filter = new SofasFlow(chip);
        filter.initFilter();
        filter.setFilterEnabled(true);
    }

    private byte[] written(String kind) throws IOException {
        return Files.readAllBytes(Path.of(name + kind));
    }

    private void assertWrites(List<EventBatch> film, boolean alsoDead) throws IOException {
        ByteArrayOutputStream flow = new ByteArrayOutputStream();
        ByteArrayOutputStream tracks = new ByteArrayOutputStream();
        ByteArrayOutputStream segments = new ByteArrayOutputStream();
        List<Segment> all = new ArrayList<>();
        Sofas sofas = new Sofas(Packets.SENSOR, SofasParameters.defaults(), all::add);
        FlowOutput output = new FlowOutput(500);
        try (FlowCsvWriter flowWriter = new FlowCsvWriter(flow); TrackTable table = TrackTable.csv(tracks)) {
            for (EventBatch batch : FILM) {
                sofas.process(batch, output);
                if (film.contains(batch)) {
                    flowWriter.write(batch, output);
                    table.add(batch, output);
                }
            }
        }
        if (!alsoDead) {
            all.clear();
        }
        all.addAll(sofas.segments());
        SegmentsCsv.write(segments, all);
        assertArrayEquals(flow.toByteArray(), written(".flow.csv"));
        assertArrayEquals(tracks.toByteArray(), written(".tracks.csv"));
        assertArrayEquals(segments.toByteArray(), written(".segments.csv"));
    }

    @Test
    public void sessionHasAllPacketsWhileItIsOn() throws IOException {
        filter.beginSession(name);
        FILM.forEach(batch -> filter.filterPacket(Packets.of(batch)));
        filter.endSession();
        assertWrites(FILM, true);
    }

    @Test
    public void sessionEndsWhereTheRecordingIsRewound() throws IOException {
        filter.beginSession(name);
        FILM.forEach(batch -> filter.filterPacket(Packets.of(batch)));
        filter.resetFilter();
        FILM.forEach(batch -> filter.filterPacket(Packets.of(batch)));
        filter.endSession();
        assertWrites(FILM, true);
    }

    @Test
    public void panelIsToldWhereTheSessionEndsByItself() throws Exception {
        List<String> told = new ArrayList<>();
        filter.getSupport().addPropertyChangeListener(change -> told.add(change.getPropertyName()));
        filter.beginSession(name);
        filter.resetFilter();
        javax.swing.SwingUtilities.invokeAndWait(() -> { });
        assertEquals(List.of("doToggleOffWriteSession"), told);
    }

    @Test
    public void lastPacketIsWrittenAlone() throws IOException {
        filter.setEngineAwaited(true);
        FILM.forEach(batch -> filter.filterPacket(Packets.of(batch)));
        filter.writeCsv(name);
        assertWrites(List.of(FILM.get(FILM.size() - 1)), false);
    }

    @Test
    public void saysWhichFilesWouldBeOverwritten() throws IOException {
        assertEquals(List.of(), SessionLog.existing(name));
        Files.createFile(Path.of(name + ".tracks.csv"));
        assertEquals("shown.tracks.csv exists in " + folder.getRoot().getAbsolutePath() + ". Overwrite?",
            ResultChooser.question(SessionLog.existing(name)));
        Files.createFile(Path.of(name + ".flow.csv"));
        assertEquals("shown.flow.csv, shown.tracks.csv exist in " + folder.getRoot().getAbsolutePath()
            + ". Overwrite?", ResultChooser.question(SessionLog.existing(name)));
    }

    @Test
    public void folderThatIsNotThereIsSaid() {
        List<String> said = new ArrayList<>();
        java.util.logging.Handler handler = new java.util.logging.Handler() {
            @Override
            public void publish(java.util.logging.LogRecord entry) {
                said.add(entry.getMessage());
            }

            @Override
            public void flush() {
            }

            @Override
            public void close() {
            }
        };
        EventFilter.log.addHandler(handler);
        EventFilter.log.setUseParentHandlers(false);
        try {
            filter.beginSession(folder.getRoot().toPath().resolve("no/such"));
        } finally {
            EventFilter.log.removeHandler(handler);
        }
        assertTrue(said.toString(), said.get(0).startsWith("SOFAS could not write "));
    }
}
