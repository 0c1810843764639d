package io.github.sofas.host;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The talk with a filter, which a shell script plays. */
public class JaerFilterTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private JaerFilter start(String script) throws IOException {
        return start(script, Duration.ofSeconds(60));
    }

    private JaerFilter start(String script, Duration longest) throws IOException {
        if (!Files.isExecutable(Path.of("/bin/sh"))) {
            throw Skipped.because("there is no /bin/sh");
        }
        Path java = folder.newFile("java").toPath();
        Files.writeString(java, "#!/bin/sh\n" + script + "\n");
        assertTrue(java.toFile().setExecutable(true));
        return JaerFilter.start(Path.of("sofas-jAER.jar"), folder.getRoot().toPath(), java, Display.open(":0"),
            "a.Filter", new SensorSize(4, 3), longest);
    }

    @Test
    public void labelsWhatTheFilterLabels() throws IOException {
        // ready; 1,000,000 ns; (1, -2) of segment 7; no flow
        try (JaerFilter filter = start("printf '\\000\\005\\017\\245';"
                + "printf '\\000\\000\\000\\000\\000\\017\\102\\100';"
                + "printf '\\077\\200\\000\\000\\300\\000\\000\\000\\000\\000\\000\\007';"
                + "printf '\\177\\300\\000\\000\\177\\300\\000\\000\\000\\000\\000\\000'; cat >/dev/null")) {
            EventBatch batch = new EventBatch(2);
            batch.add(10, 1, 1, 1);
            batch.add(11, 1, 2, -1);
            FlowOutput output = new FlowOutput(2);
            filter.process(batch, output);
            assertArrayEquals(new int[] {7, 0}, output.segment);
            assertArrayEquals(new float[] {1, 0}, output.vxPxPerS, 0);
            assertArrayEquals(new float[] {-2, 0}, output.vyPxPerS, 0);
            assertEquals(0.001, filter.seconds(), 1e-12);
        }
    }

    @Test
    public void saysWhatJaerSaidLastWhereItDoesNotStart() {
        assertEquals("[x] must be jAER's folder", assertThrows(JaerException.class,
            () -> start("echo starting >&2; echo \"[x] must be jAER's folder\" >&2; exit 1")).getMessage());
    }

    @Test
    public void saysWhyTheFilterThrew() {
        assertEquals("Caused by: java.lang.NoSuchFieldError: y", assertThrows(JaerException.class,
            () -> start("echo 'Caused by: java.lang.NoSuchFieldError: y' >&2; echo '  at a.b' >&2")).getMessage());
    }

    @Test
    public void saysSoWhereJaerEndsWithoutAWord() {
        assertEquals("jAER ended before a.Filter was ready",
            assertThrows(JaerException.class, () -> start("exit 3")).getMessage());
    }

    /** What the script starts keeps its output open, as jAER does for the starter. */
    @Test
    public void givesUpWhereJaerSaysNothing() {
        assertEquals("a.Filter was not ready in jAER within 1 s", assertThrows(JaerException.class,
            () -> start("sleep 600; exit 3", Duration.ofSeconds(1))).getMessage());
    }

    @Test
    public void saysWhatJaerSaidBeforeItFellSilent() {
        assertEquals("a.Filter was not ready in jAER within 1 s; jAER said last: Exception in thread \"main\" x",
            assertThrows(JaerException.class, () -> start("echo 'Exception in thread \"main\" x' >&2; sleep 600",
                Duration.ofSeconds(1))).getMessage());
    }

    @Test
    public void saysSoWhereJaerEndsEarly() throws IOException {
        try (JaerFilter filter = start("printf '\\000\\005\\017\\245'; echo 'Exception in thread \"main\" x' >&2")) {
            EventBatch batch = new EventBatch(1);
            batch.add(10, 1, 1, 1);
            assertEquals("jAER ended early: Exception in thread \"main\" x", assertThrows(UncheckedIOException.class,
                () -> filter.process(batch, new FlowOutput(1))).getMessage());
        }
    }
}
