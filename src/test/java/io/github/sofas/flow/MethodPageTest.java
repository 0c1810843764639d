package io.github.sofas.flow;

import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.Test;

/** Holds the page about the method to the code. */
public class MethodPageTest {
    private static final Path PAGE = Path.of("docs/method.md");
    private static final Path FLOW = Path.of("src/main/java/io/github/sofas/flow");

    private static List<String> all(String pattern, String text) {
        List<String> found = new ArrayList<>();
        for (Matcher matcher = Pattern.compile(pattern).matcher(text); matcher.find();) {
            found.add(matcher.group(1));
        }
        return found;
    }

    @Test
    public void everyClassThatItNamesIsAFile() throws IOException {
        String page = Files.readString(PAGE).replace("`ArchitectureTest`", "");
        List<String> classes = all("`((?:[a-z]+\\.)?[A-Z][A-Za-z]+)`", page);
        assertTrue("classes " + classes.size(), classes.size() > 100);
        for (String each : classes) {
            boolean inARoom = List.of("", "motion/", "fit/", "search/", "track/", "smooth/", "paper/").stream()
                .anyMatch(room -> Files.exists(FLOW.resolve(room + each.replace('.', '/') + ".java")));
            assertTrue(each, inARoom);
        }
    }

    @Test
    public void everyParameterThatItNamesIsOne() throws IOException {
        List<String> names = all("\\(`([a-z][A-Za-z]+)`|, `([a-z][A-Za-z]+)`\\)", Files.readString(PAGE));
        assertTrue(names.size() >= 4);
        names.stream().filter(name -> name != null).forEach(ParameterHandle::named);
    }
}
