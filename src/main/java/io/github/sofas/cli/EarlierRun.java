package io.github.sofas.cli;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * What the summary of an earlier run says of it. The summary gets its name last of all results, so that none of them is
 * missing where it is there.
 *
 * @param request what was asked for, as {@link RecordingRun#request()} tells it; null where the summary does not say
 * @param complete whether the recording was read to its end
 * @param doubtfulShare share of its events that were corrected, dropped or malformed
 */
record EarlierRun(String request, boolean complete, double doubtfulShare) {
    private static final JsonFactory FACTORY = new JsonFactory();

    /** Reads a summary; null where there is none, or the file is something else. */
    static EarlierRun of(Path summary) {
        if (!Files.isRegularFile(summary)) {
            return null;
        }
        String request = null;
        boolean complete = false;
        double doubtfulShare = 0;
        try (JsonParser json = FACTORY.createParser(summary.toFile())) {
            while (json.nextToken() != null) {
                String path = json.getParsingContext().pathAsPointer().toString();
                if (path.equals("/request") && json.currentToken() == JsonToken.VALUE_STRING) {
                    request = json.getText();
                } else if (path.equals("/recording/complete")) {
                    complete = json.currentToken() == JsonToken.VALUE_TRUE;
                } else if (path.equals("/recording/doubtful_share") && json.currentToken().isNumeric()) {
                    doubtfulShare = json.getDoubleValue();
                }
            }
        } catch (IOException e) {
            return null;
        }
        return new EarlierRun(request, complete, doubtfulShare);
    }
}
