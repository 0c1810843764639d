package io.github.sofas.cli;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;

/**
 * What the summary of an earlier run says about it. The summary gets its name last of all results, so that its presence
 * shows that none of them is missing.
 *
 * @param request what was asked for, as {@link RecordingRun#request()} gives it; null if the summary does not have it
 * @param complete whether the recording was read to its end
 * @param doubtfulShare share of the recording's events that were corrected, dropped or malformed
 * @param fileBytes sizes of the other results when they were written, by name
 * @param values every text, number and Boolean of the summary, by its JSON pointer
 */
record EarlierRun(String request, boolean complete, double doubtfulShare, Map<String, Long> fileBytes,
                  Map<String, String> values) {
    private static final JsonFactory FACTORY = new JsonFactory();

    /** Reads a summary; null if there is none, or the file is no JSON. */
    static EarlierRun of(Path summary) {
        if (!Files.isRegularFile(summary)) {
            return null;
        }
        String request = null;
        boolean complete = false;
        double doubtfulShare = 0;
        Map<String, Long> fileBytes = new HashMap<>();
        Map<String, String> values = new LinkedHashMap<>();
        try (JsonParser json = FACTORY.createParser(summary.toFile())) {
            while (json.nextToken() != null) {
                String path = json.getParsingContext().pathAsPointer().toString();
                if (json.currentToken().isScalarValue()) {
                    values.put(path, json.getText());
                }
                if (path.equals("/request") && json.currentToken() == JsonToken.VALUE_STRING) {
                    request = json.getText();
                } else if (path.equals("/recording/complete")) {
                    complete = json.currentToken() == JsonToken.VALUE_TRUE;
                } else if (path.equals("/recording/doubtful_share") && json.currentToken().isNumeric()) {
                    doubtfulShare = json.getDoubleValue();
                } else if (path.startsWith("/file_bytes/") && json.currentToken() == JsonToken.VALUE_NUMBER_INT) {
                    fileBytes.put(json.currentName(), json.getLongValue());
                }
            }
        } catch (IOException e) {
            return null;
        }
        return new EarlierRun(request, complete, doubtfulShare, fileBytes, values);
    }

    /**
     * Why the earlier results are not those of the requested run; null if they are, and are complete.
     *
     * @param wanted the request of that run
     * @param bytes present sizes of the results, by name; 0 for one that is missing
     */
    String whyNot(String wanted, Map<String, Long> bytes) {
        String[] now = wanted.split(" ");
        String[] before = request == null ? new String[0] : request.split(" ");
        if (before.length != now.length) {
            return "its results are of another program, or of an older version";
        }
        if (!before[0].equals(now[0])) {
            return "its results are of version " + before[0] + " and this is " + now[0];
        }
        if (!before[1].equals(now[1])) {
            return "the recording has another size or time of change than it had";
        }
        if (!before[2].equals(now[2])) {
            return "its results are of other options or parameters";
        }
        if (!complete) {
            return "the recording could not be read to its end";
        }
        for (Map.Entry<String, Long> file : new TreeMap<>(bytes).entrySet()) {
            Long then = fileBytes.get(file.getKey());
            if (then != null && !then.equals(file.getValue())) {
                return file.getKey() + " must have " + then + " bytes but has " + file.getValue();
            }
        }
        return null;
    }
}
