package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.junit.After;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** All that is written is the same in every locale: digits, points, letters, films. */
public class LocaleTest {
    private static final String BAR = "recordings/short-bar.aedat";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private final Locale before = Locale.getDefault();

    @After
    public void giveTheLocaleBack() {
        Locale.setDefault(before);
    }

    /** Every file that the commands write, and all that they print, in a locale. */
    private Map<String, String> outputs(String locale) throws IOException {
        Locale.setDefault(Locale.forLanguageTag(locale));
        Path out = folder.newFolder().toPath();
        Map<String, String> all = new TreeMap<>();
        String truth = "recordings/short-bar.truth.csv";
        for (String[] command : new String[][] {
            {"run", BAR, "--out", out.toString(), "--report", "--config", "none"},
            {"run", BAR, "--out", out.toString(), "--report"},
            {"render", BAR, "--out", out.toString(), "--to", "0.1", "--format", "gif",
                "--panels", "events,flow,segments,contours"},
            {"render", BAR, "--out", out.toString(), "--to", "0.1", "--encoder", "jcodec"},
            {"simulate", "hexagon", "--duration", "0.05", "--out", out.toString()},
            {"evaluate", BAR, "--truth", truth, "--csv", out + "/e.csv", "--json", out + "/e.json"},
            {"info", BAR}, {"info", "--json", BAR}, {"simulate", "--list"}, {"run", "--help"},
            {"render", BAR, "--out", out.toString(), "--fps", "-1"}}) {
            Executed executed = Executed.command(command);
            all.put(String.join(" ", command).replace(out.toString(), "OUT"), plain(executed.out + executed.err, out));
        }
        try (var files = Files.list(out)) {
            for (Path file : files.toList()) {
                all.put(file.getFileName().toString(),
                    plain(new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1), out));
            }
        }
        return all;
    }

    /** Without what differs from run to run: the folder, and how long it took. */
    private static String plain(String text, Path out) {
        return text.replace(out.toString(), "OUT").replaceAll("[0-9.,]+ (s|events/s)\\b", "N $1")
            .replaceAll("(\"[a-z_]*(wall|seconds|decode|engine|output|per_second|heap_bytes)\" : )[0-9.]+", "$1N")
            .replaceAll("\"short-bar.report.html\" : [0-9]+", "SIZE");
    }

    @Test
    public void allThatIsWrittenIsTheSameInEveryLocale() throws Exception {
        Map<String, String> root = outputs("en-US");
        assertTrue(root.keySet().toString(), root.keySet().containsAll(List.of("short-bar.report.html",
            "short-bar.gif", "short-bar.mp4", "short-bar.flow.csv", "hexagon.aedat", "e.json")));
        for (String locale : List.of("ar-EG", "fa-IR", "tr-TR")) {
            Map<String, String> other = outputs(locale);
            assertEquals(locale, root.keySet(), other.keySet());
            for (Map.Entry<String, String> entry : root.entrySet()) {
                String text = other.get(entry.getKey());
                int at = 0;
                while (at < Math.min(text.length(), entry.getValue().length())
                        && text.charAt(at) == entry.getValue().charAt(at)) {
                    at++;
                }
                assertTrue(locale + ", " + entry.getKey() + " at " + at + ": "
                    + text.substring(Math.max(0, Math.min(at - 40, text.length())), Math.min(text.length(), at + 60))
                    + "\n instead of " + entry.getValue().substring(Math.max(0, Math.min(at - 40,
                    entry.getValue().length())), Math.min(entry.getValue().length(), at + 60)),
                    text.equals(entry.getValue()));
            }
        }
    }
}
