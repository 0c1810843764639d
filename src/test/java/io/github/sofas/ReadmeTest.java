package io.github.sofas;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Holds the README to the code. */
public class ReadmeTest {
    @Rule
    public final TemporaryFolder classes = new TemporaryFolder();

    @Test
    public void theJavaExampleCompiles() throws IOException {
        Matcher example = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(Path.of("README.md")));
        assertTrue("an example", example.find());
        String program = """
            import io.github.sofas.event.*;
            import io.github.sofas.flow.*;
            import io.github.sofas.recording.*;
            import java.nio.file.Path;
            class Example {
                static void run() throws Exception {
            """ + example.group(1) + "}}";

        assertEquals("", faults(program));
    }

    @Test
    public void everyFileItLinksToExists() throws IOException {
        Matcher link = Pattern.compile("\\]\\((?!https?:)([^)#]+)").matcher(Files.readString(Path.of("README.md")));
        while (link.find()) {
            assertTrue(link.group(1), Files.exists(Path.of(link.group(1))));
        }
    }

    private String faults(String program) {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        if (compiler == null) {
            throw Skipped.because("this Java has no compiler");
        }
        JavaFileObject source = new SimpleJavaFileObject(URI.create("string:///Example.java"),
            JavaFileObject.Kind.SOURCE) {
            @Override
            public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                return program;
            }
        };
        StringWriter faults = new StringWriter();
        String classPath = System.getProperty("java.class.path");
        compiler.getTask(faults, null, null, List.of("-cp", classPath, "-d", classes.getRoot().getPath()), null,
            List.of(source)).call();
        return faults.toString();
    }
}
