package io.github.sofas.export;

import com.fasterxml.jackson.core.JsonGenerator;
import io.github.sofas.event.SensorSize;
import java.io.IOException;
import java.util.List;
import java.util.Map;

/**
 * A summary of what a recording contains.
 *
 * @param file path of the file as it was given
 * @param format name and version of the format
 * @param chip name of the sensor chip, empty if unknown
 * @param sensor the pixel array
 * @param events number of DVS events delivered
 * @param firstTimeUs time of the first event in µs; 0 if there is none
 * @param lastTimeUs time of the last event in µs; 0 if there is none
 * @param counts number of items of each kind in the file, by name, in the order shown
 * @param complete whether the recording was read to its end without damage
 * @param faults faults of the recording, one message each; empty for a sound recording
 * @param notes further remarks for the user
 * @param doubtfulShare share of the events that are not delivered as the recording has them, 0 to 1
 */
public record RecordingSummary(String file, String format, String chip, SensorSize sensor, long events,
                               long firstTimeUs, long lastTimeUs, Map<String, Long> counts, boolean complete,
                               List<String> faults, List<String> notes, double doubtfulShare) {

    /** {@return the time from the first event to the last in seconds} */
    public double durationS() {
        return (lastTimeUs - firstTimeUs) / 1e6;
    }

    /** {@return DVS events per second of the recording; 0 if it has no duration} */
    public double eventsPerS() {
        return durationS() > 0 ? events / durationS() : 0;
    }

    /**
     * Writes a JSON object.
     *
     * @param json the document, inside an object
     * @throws IOException if the object cannot be written
     */
    public void write(JsonGenerator json) throws IOException {
        json.writeStartObject();
        json.writeStringField("file", file);
        json.writeStringField("format", format);
        json.writeStringField("chip", chip);
        json.writeNumberField("width", sensor.width());
        json.writeNumberField("height", sensor.height());
        json.writeNumberField("events", events);
        json.writeNumberField("first_t_us", firstTimeUs);
        json.writeNumberField("last_t_us", lastTimeUs);
        Json.write(json, "duration_s", durationS(), 6);
        Json.write(json, "events_per_s", eventsPerS(), 1);
        json.writeObjectFieldStart("counts");
        for (Map.Entry<String, Long> count : counts.entrySet()) {
            json.writeNumberField(count.getKey(), count.getValue());
        }
        json.writeEndObject();
        json.writeBooleanField("complete", complete);
        json.writeArrayFieldStart("faults");
        for (String fault : faults) {
            json.writeString(fault);
        }
        json.writeEndArray();
        json.writeArrayFieldStart("notes");
        for (String note : notes) {
            json.writeString(note);
        }
        json.writeEndArray();
        Json.write(json, "doubtful_share", doubtfulShare, 6);
        json.writeEndObject();
    }
}
