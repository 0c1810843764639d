package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;

/**
 * An MP4 file with H.264 video, which browsers and players show without further software. The encoder is {@code ffmpeg}
 * if it is on PATH and has an H.264 encoder, otherwise jcodec. jcodec takes three times as long and makes files several
 * times as large. Either encoder gives the same bytes for the same pictures; those of ffmpeg depend on its version.
 */
public final class Mp4Film implements Film {
    private final Path file;
    private final double fps;
    private final Ffmpeg ffmpeg;
    private Film film;

    /**
     * Starts a film, encoded by the best encoder on this machine.
     *
     * @param file receives the film; must not be in use
     * @param fps pictures per second
     * @throws IOException never
     */
    public Mp4Film(Path file, double fps) throws IOException {
        this(file, fps, Encoder.AUTO);
    }

    /**
     * Starts a film.
     *
     * @param file receives the film; must not be in use
     * @param fps pictures per second
     * @param encoder encoder of the film
     * @throws IOException if {@code FFMPEG} is requested, but ffmpeg is not on PATH or has no H.264 encoder
     */
    public Mp4Film(Path file, double fps, Encoder encoder) throws IOException {
        this.file = file;
        this.fps = fps;
        ffmpeg = encoder == Encoder.JCODEC ? null : Ffmpeg.onPath();
        if (ffmpeg == null && encoder == Encoder.FFMPEG) {
            throw new IOException("there is no ffmpeg with an H.264 encoder on PATH");
        }
    }

    /** The encoder of an MP4 file. */
    public enum Encoder {
        /** ffmpeg if it is on PATH with an H.264 encoder, otherwise jcodec. */
        AUTO,
        /** The program {@code ffmpeg} on PATH, with libx264 or libopenh264. */
        FFMPEG,
        /** A library that comes with SOFAS. */
        JCODEC
    }

    /** {@return the encoder of this film, never {@link Encoder#AUTO}} */
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

    /** Completes the file; a film without pictures makes no file. May be called more than once. */
    @Override
    public void close() throws IOException {
        if (film != null) {
            film.close();
        }
    }
}
