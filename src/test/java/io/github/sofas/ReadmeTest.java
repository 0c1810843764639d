package io.github.sofas;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Holds the README and the pages beside it to the code and to each other. */
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
    public void everyFileThatThePagesLinkToExists() throws IOException {
        for (Path page : pages()) {
            Matcher link = Pattern.compile("\\]\\((?!https?:)([^)#]+)").matcher(Files.readString(page));
            while (link.find()) {
                assertTrue(page + ": " + link.group(1), Files.exists(page.resolveSibling(link.group(1)).normalize()));
            }
        }
    }

    /** A page that no other links to is not found. */
    @Test
    public void everyPageIsLinkedTo() throws IOException {
        Set<Path> linked = new HashSet<>(List.of(Path.of("README.md")));
        for (Path page : pages()) {
            Matcher link = Pattern.compile("\\]\\(([^)#:]+\\.md)").matcher(Files.readString(page));
            while (link.find()) {
                linked.add(page.resolveSibling(link.group(1)).normalize());
            }
        }
        assertEquals(Set.copyOf(pages()), linked);
    }

    private static List<Path> pages() throws IOException {
        List<Path> pages = new ArrayList<>(List.of(Path.of("README.md"), Path.of("CONTRIBUTING.md"),
            Path.of("CHANGELOG.md"), Path.of("DEPENDENCIES.md"), Path.of("plugins/jaer/README.md")));
        try (Stream<Path> docs = Files.list(Path.of("docs"))) {
            docs.filter(page -> page.toString().endsWith(".md")).forEach(pages::add);
        }
        return pages;
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
