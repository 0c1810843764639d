package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.GreyFrame;
import io.github.sofas.event.SensorSize;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.LabelledSource;
import io.github.sofas.flow.Sofas;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import io.github.sofas.render.Film;
import io.github.sofas.render.GifFilm;
import io.github.sofas.render.Mp4Film;
import io.github.sofas.render.Panel;
import io.github.sofas.render.PictureOptions;
import io.github.sofas.render.PictureSheet;
import io.github.sofas.render.PngFilm;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Locale;
import java.util.Queue;

/**
 * Makes the film of one recording. The events are labelled, or get labels that were written before, and a picture is
 * painted whenever one is due.
 *
 * @param recording the recording that is shown
 * @param options how the recording is read
 * @param method labels the events
 * @param flow file of labels that were written before; null if the method is to label
 * @param file the film
 * @param format of the film
 * @param encoder of MP4
 * @param pictures what a picture shows
 * @param timing when there is a picture
 */
record RenderRun(Path recording, RecordingOptions options, MethodChoice method, Path flow, Path file, Format format,
                 Mp4Film.Encoder encoder, PictureOptions pictures, Timing timing) {
    private static final int BATCH = 4096;
    /** Frames that may wait for their time. If a batch brings more, the oldest are not shown. */
    private static final int MOST_FRAMES = 256;

    /** File format of a film. */
    enum Format {
        MP4(".mp4"), GIF(".gif"), PNG(".png.zip");

        final String ending;

        Format(String ending) {
            this.ending = ending;
        }

        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /**
     * Determines when there is a picture.
     *
     * @param fps pictures per second of film
     * @param stepUs time of the recording between two pictures, µs
     * @param every events between two pictures; 0 if time determines the pictures
     * @param fromS beginning, s from the first event
     * @param toS end, s from the first event
     * @param maxPictures largest number of pictures
     */
    record Timing(double fps, double stepUs, long every, double fromS, double toS, long maxPictures) {
    }

    /**
     * The outcome of a run.
     *
     * @param pictures number of pictures
     * @param events number of events read
     * @param recordingS time of the recording from the first to the last of these events
     * @param wallS time that the run took
     * @param endsEarly whether the film reached the largest number of pictures, and events are left
     * @param notes what the user should know about the recording
     * @param faults what is wrong with the recording
     * @param doubtfulShare share of the recording's events that were corrected, dropped or malformed
     * @param damage why the recording could not be read to its end; null if it was
     * @param encoder the encoder that was used; null if the film is no MP4
     */
    record Outcome(long pictures, long events, double recordingS, double wallS, boolean endsEarly,
                   List<String> notes, List<String> faults, double doubtfulShare, EventSourceException damage,
                   Mp4Film.Encoder encoder) {
    }

    /**
     * Makes the film under a temporary name, which it has until the caller commits the files.
     *
     * @throws EventSourceException if the recording cannot be opened or has no event to show
     * @throws IOException if the film cannot be written
     * @throws IllegalArgumentException if the pictures that are asked for are impossible with this sensor
     */
    Outcome run(ResultFiles files, RunProgress progress) throws EventSourceException, IOException {
        long start = System.nanoTime();
        try (RecordingReader reader = Recordings.open(recording, options);
                StoredLabels stored = flow == null ? null : StoredLabels.open(flow, recording, reader, BATCH);
                Film film = film(files);
                OpenLabelling ahead = flow == null && method.looksAhead() ? method.open(reader.sensor()) : null) {
            SensorSize sensor = reader.sensor();
            PictureSheet sheet = new PictureSheet(sensor, pictures);
            Queue<GreyFrame> frames = new ArrayDeque<>();
            if (pictures.panels().contains(Panel.GREY)) {
                reader.onFrame(frame -> {
                    frames.add(frame);
                    if (frames.size() > MOST_FRAMES) {
                        frames.remove();
                    }
                });
            }
            LabelledEvents events = stored != null ? stored::next
                : ahead != null ? new LabelledSource(reader, ahead.labelling())::next
                : (batch, labels) -> reader.next(batch);
            EventLabeller labeller = stored == null && ahead == null ? method.make(sensor, ended -> { }) : null;
            Shooting shooting = new Shooting(sheet, film, timing, labeller, frames);
            EventBatch batch = new EventBatch(BATCH);
            FlowOutput labels = new FlowOutput(BATCH);
            EventSourceException damage = null;
            try {
                while (!shooting.isOver() && events.next(batch, labels)) {
                    shooting.take(batch, labels);
                    progress.reached(reader.bytesRead());
                }
            } catch (EventSourceException e) {
                damage = e;
            }
            shooting.end();
            if (shooting.pictures() == 0) {
                throw damage != null ? damage : new EventSourceException("[" + recording.getFileName() + "] there must "
                    + "be an event between --from and --to but there was none");
            }
            return new Outcome(shooting.pictures(), shooting.events(), shooting.recordingS(),
                (System.nanoTime() - start) / 1e9, shooting.endsEarly(), reader.notes(), reader.faults(),
                reader.counts().doubtfulShare(), damage, film instanceof Mp4Film ? ((Mp4Film) film).encoder() : null);
        }
    }

    private Film film(ResultFiles files) throws IOException {
        switch (format) {
            case GIF:
                return new GifFilm(files.create(file), timing.fps());
            case PNG:
                return new PngFilm(files.create(file));
            default:
                // encoders seek back in the file, which a stream cannot do
                files.create(file).close();
                return new Mp4Film(files.temporary(file), timing.fps(), encoder);
        }
    }

    /** Splits the events where pictures are due, labels each part and paints the pictures. */
    private static final class Shooting {
        private final PictureSheet sheet;
        private final Film film;
        private final Timing timing;
        private final EventLabeller labeller;
        /** Frames that were read and are shown when their time has come. */
        private final Queue<GreyFrame> frames;
        private final EventBatch part = new EventBatch(BATCH);
        private final FlowOutput partLabels = new FlowOutput(BATCH);
        private long firstUs;
        private long lastUs;
        private long events;
        private long sincePicture;
        private long pictures;
        private boolean over;
        private boolean endsEarly;

        Shooting(PictureSheet sheet, Film film, Timing timing, EventLabeller labeller, Queue<GreyFrame> frames) {
            this.sheet = sheet;
            this.film = film;
            this.timing = timing;
            this.labeller = labeller;
            this.frames = frames;
        }

        /** Takes a batch; its labels are used only if there is no labeller. */
        void take(EventBatch batch, FlowOutput labels) throws IOException {
            if (events == 0) {
                firstUs = batch.timeUs[0];
            }
            int from = 0;
            for (int i = 0; i < batch.size() && !over; i++) {
                long timeUs = batch.timeUs[i];
                while (!over && isDue(timeUs)) {
                    pass(batch, labels, from, i);
                    from = i;
                    shoot(timing.every() > 0 ? lastUs : dueUs());
                }
                boolean isPastEnd = timeUs - firstUs > timing.toS() * 1e6;
                if (over) {
                    endsEarly = !isPastEnd;
                    return;
                }
                if (isPastEnd) {
                    over = true;
                    pass(batch, labels, from, i);
                    return;
                }
                events++;
                sincePicture++;
                lastUs = timeUs;
            }
            if (from < batch.size()) {
                pass(batch, labels, from, batch.size());
            }
        }

        /** Whether a picture comes before an event of this time. */
        private boolean isDue(long timeUs) {
            return timing.every() > 0 ? sincePicture >= timing.every() : timeUs >= dueUs();
        }

        private long dueUs() {
            return firstUs + Math.round(timing.fromS() * 1e6 + (pictures + 1) * timing.stepUs());
        }

        private void pass(EventBatch batch, FlowOutput labels, int from, int to) {
            if (labeller == null) {
                sheet.add(batch, labels, from, to);
                return;
            }
            part.clear();
            part.addAll(batch, from, to - from);
            labeller.process(part, partLabels);
            sheet.add(part, partLabels, 0, part.size());
        }

        private void shoot(long timeUs) throws IOException {
            sincePicture = 0;
            if (timeUs - firstUs < timing.fromS() * 1e6) {
                return;
            }
            while (!frames.isEmpty() && frames.peek().timeUs() <= timeUs) {
                sheet.show(frames.remove());
            }
            BufferedImage picture = sheet.paint(timeUs, timeUs - firstUs,
                labeller instanceof Sofas ? (Sofas) labeller : null);
            film.add(picture);
            pictures++;
            over |= pictures == timing.maxPictures();
        }

        /** Paints the events after the last picture. */
        void end() throws IOException {
            if (pictures < timing.maxPictures() && sincePicture > 0) {
                shoot(lastUs);
            }
        }

        boolean isOver() {
            return over;
        }

        /** Whether the film has as many pictures as it may have, and events are left. */
        boolean endsEarly() {
            return endsEarly;
        }

        long pictures() {
            return pictures;
        }

        long events() {
            return events;
        }

        double recordingS() {
            return (lastUs - firstUs) * 1e-6;
        }
    }
}
