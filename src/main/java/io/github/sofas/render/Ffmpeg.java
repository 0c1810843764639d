package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The program {@code ffmpeg} on PATH. It receives raw pictures through a pipe and writes an MP4. It runs on one thread
 * and writes neither dates nor versions into the headers of the file, so that the same pictures give the same bytes.
 *
 * @param program path of the program
 * @param options its H.264 encoder, followed by the options that determine the quality
 */
record Ffmpeg(Path program, List<String> options) {
    /**
     * Encoders with their options. The first one that ffmpeg has is taken; an ffmpeg built without the GPL has the
     * second.
     */
    private static final List<List<String>> ENCODERS = List.of(
        List.of("libx264", "-preset", "veryfast", "-crf", "18"),
        List.of("libopenh264", "-rc_mode", "off", "-g", "300"));

    /** {@return the first ffmpeg on PATH; null if there is none, or if it has no encoder for H.264} */
    static Ffmpeg onPath() {
        String path = System.getenv("PATH");
        for (String folder : path == null ? new String[0] : path.split(File.pathSeparator)) {
            for (String name : new String[] {"ffmpeg", "ffmpeg.exe"}) {
                Path program = Path.of(folder, name);
                if (Files.isRegularFile(program) && Files.isExecutable(program)) {
                    return of(program);
                }
            }
        }
        return null;
    }

    private static Ffmpeg of(Path program) {
        try {
            Process process = new ProcessBuilder(program.toString(), "-hide_banner", "-encoders")
                .redirectError(ProcessBuilder.Redirect.DISCARD).start();
            process.getOutputStream().close();
            String encoders = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            for (List<String> options : ENCODERS) {
                if (encoders.contains(" " + options.get(0) + " ")) {
                    return new Ffmpeg(program, options);
                }
            }
            return null;
        } catch (IOException e) {
            // a file of that name that is not a program
            return null;
        }
    }

    /** Starts the program and returns the film that sends pictures to it. */
    Film film(Path file, double fps, int width, int height) throws IOException {
        List<String> command = new ArrayList<>(List.of(program.toString(), "-hide_banner", "-loglevel", "error",
            "-f", "rawvideo", "-pixel_format", "bgr0", "-video_size", width + "x" + height,
            "-framerate", Double.toString(fps), "-i", "pipe:0", "-an", "-c:v"));
        command.addAll(options);
        command.addAll(List.of("-pix_fmt", "yuv420p", "-threads", "1", "-fflags", "+bitexact", "-flags:v", "+bitexact",
            "-movflags", "+faststart", "-f", "mp4", "-y", "file:" + file.toAbsolutePath()));
        return new Pictures(command, width, height);
    }

    /** A film whose pictures go to the standard input of the program. */
    private static final class Pictures implements Film {
        private final Path messages = Files.createTempFile("sofas-ffmpeg", ".txt");
        private final Process process;
        private final OutputStream out;
        private final ByteBuffer bytes;
        private boolean closed;

        Pictures(List<String> command, int width, int height) throws IOException {
            process = new ProcessBuilder(command).redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(messages.toFile()).start();
            out = process.getOutputStream();
            // blue, green, red and an unused byte
            bytes = ByteBuffer.allocate(4 * width * height).order(ByteOrder.LITTLE_ENDIAN);
        }

        @Override
        public void add(BufferedImage picture) throws IOException {
            bytes.asIntBuffer().put(((DataBufferInt) picture.getRaster().getDataBuffer()).getData());
            try {
                out.write(bytes.array());
            } catch (IOException e) {
                // the program has ended; close() throws with its messages, which give the reason
                close();
                throw e;
            }
        }

        /** Waits until the program has ended. */
        @Override
        public void close() throws IOException {
            if (closed) {
                return;
            }
            closed = true;
            IOException fault = null;
            try {
                out.close();
            } catch (IOException e) {
                fault = e;
            }
            try {
                int code = process.waitFor();
                if (code != 0) {
                    String said = Files.readString(messages).strip();
                    throw new IOException("ffmpeg ended with " + code + (said.isEmpty() ? "" : ": " + said));
                }
                if (fault != null) {
                    throw fault;
                }
            } catch (InterruptedException e) {
                process.destroy();
                Thread.currentThread().interrupt();
                throw new IOException("interrupted while ffmpeg was writing", e);
            } finally {
                Files.deleteIfExists(messages);
            }
        }
    }
}
