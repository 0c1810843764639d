package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;

/**
 * An MP4 file with H.264 video, which browsers and players show without further software. Encoded by {@code ffmpeg}
 * where it is on PATH with an H.264 encoder, else by jcodec, which takes three times as long and files several times as
 * large. Either gives the same bytes for the same pictures; ffmpeg's depend on its version.
 */
public final class Mp4Film implements Film {
    private final Path file;
    private final double fps;
    private final Ffmpeg ffmpeg;
    private Film film;

    /**
     * Starts a film, encoded by the best encoder on this machine.
     *
     * @param file gets the film; must not be in use
     * @param fps pictures per second
     * @throws IOException never
     */
    public Mp4Film(Path file, double fps) throws IOException {
        this(file, fps, Encoder.AUTO);
    }

    /**
     * Starts a film.
     *
     * @param file gets the film; must not be in use
     * @param fps pictures per second
     * @param encoder which encodes it
     * @throws IOException where ffmpeg is asked for and not on PATH, or has no H.264 encoder
     */
    public Mp4Film(Path file, double fps, Encoder encoder) throws IOException {
        this.file = file;
        this.fps = fps;
        ffmpeg = encoder == Encoder.JCODEC ? null : Ffmpeg.onPath();
        if (ffmpeg == null && encoder == Encoder.FFMPEG) {
            throw new IOException("there is no ffmpeg with an H.264 encoder on PATH");
        }
    }

    /** What encodes an MP4. */
    public enum Encoder {
        /** ffmpeg where it is on PATH, else jcodec. */
        AUTO,
        /** The program {@code ffmpeg} on PATH, with libx264 or libopenh264. */
        FFMPEG,
        /** A library that comes with SOFAS. */
        JCODEC
    }

    /** {@return what encodes this film, never {@link Encoder#AUTO}} */
    public Encoder encoder() {
        return ffmpeg != null ? Encoder.FFMPEG : Encoder.JCODEC;
    }

    @Override
    public void add(BufferedImage picture) throws IOException {
        if (film == null) {
            film = ffmpeg != null ? ffmpeg.film(file, fps, picture.getWidth(), picture.getHeight())
                : new JcodecFilm(file, fps, picture.getWidth(), picture.getHeight());
        }
        film.add(picture);
    }

    /** Completes the file; one without pictures is not made. May be called more than once. */
    @Override
    public void close() throws IOException {
        if (film != null) {
            film.close();
        }
    }
}
