package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The README's example does what it shows. */
public class SofasExampleTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @Test
    public void readmeExamplePrintsTheFlowOfARecording() throws Exception {
        Matcher example = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(Path.of("README.md")));
        assertTrue("an example", example.find());
        List<String> lines = linesPrintedBy(example.group(1));
        // one line a batch: time of its first event, which may be noise, velocity to the right, segment
        Pattern line = Pattern.compile("(-?\\d+) µs: (-?[\\d.E-]+) px/s, segment (\\d+)");
        int labelled = 0;
        for (String printed : lines) {
            Matcher fields = line.matcher(printed);
            assertTrue(printed, fields.matches());
            if (!fields.group(3).equals("0")) {
                // the hexagon moves right at 58 px/s
                assertEquals(printed, 58, Float.parseFloat(fields.group(2)), 6);
                labelled++;
            }
        }
        assertTrue(lines.toString(), labelled > 0);
    }

    private List<String> linesPrintedBy(String body) throws Exception {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        if (compiler == null) {
            throw Skipped.because("this Java has no compiler");
        }
        Path root = folder.getRoot().toPath();
        Path source = root.resolve("Example.java");
        Files.writeString(source, "import io.github.sofas.event.*; import io.github.sofas.flow.*;"
            + "import io.github.sofas.recording.*; import java.nio.file.Path;"
            + "public class Example { public static void run() throws Exception {\n" + body + "}}");
        StringWriter faults = new StringWriter();
        compiler.getTask(faults, null, null, List.of("-encoding", "UTF-8", "-cp",
            System.getProperty("java.class.path"), "-d", root.toString()), null,
            compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8).getJavaFileObjects(source)).call();
        assertEquals("", faults.toString());
        PrintStream before = System.out;
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        try (URLClassLoader loader = new URLClassLoader(new URL[] {root.toUri().toURL()},
            getClass().getClassLoader())) {
            System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
            loader.loadClass("Example").getMethod("run").invoke(null);
        } finally {
            System.setOut(before);
        }
        return printed.toString(StandardCharsets.UTF_8).lines().toList();
    }
}
