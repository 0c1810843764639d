package io.github.sofas.recording;

import static io.github.sofas.recording.Aedat4Format.FORMAT_BGR;
import static io.github.sofas.recording.Aedat4Format.FORMAT_BGRA;
import static io.github.sofas.recording.Aedat4Format.FORMAT_GREY;
import static io.github.sofas.recording.Aedat4Format.FRAMES;
import static io.github.sofas.recording.Aedat4Format.FRAME_FORMAT;
import static io.github.sofas.recording.Aedat4Format.FRAME_HEIGHT;
import static io.github.sofas.recording.Aedat4Format.FRAME_LEFT;
import static io.github.sofas.recording.Aedat4Format.FRAME_PIXELS;
import static io.github.sofas.recording.Aedat4Format.FRAME_TIME;
import static io.github.sofas.recording.Aedat4Format.FRAME_TOP;
import static io.github.sofas.recording.Aedat4Format.FRAME_WIDTH;
import static io.github.sofas.recording.Aedat4Format.IDENTIFIER_AT;
import static io.github.sofas.recording.Aedat4Format.ROOT_AT;

import io.github.sofas.event.GreyFrame;
import io.github.sofas.event.SensorSize;

/** Decodes the frames of AEDAT 4.0 into grey levels on the sensor's pixel array. */
final class Aedat4Frames {
    private Aedat4Frames() {
    }

    /**
     * Returns a frame of the sensor's size; pixels that the packet does not cover stay dark.
     *
     * @param bytes the packet, unpacked
     * @throws MalformedFrameException where the packet holds no frame, or one that is not supported
     */
    static GreyFrame decode(byte[] bytes, int length, SensorSize sensor) throws MalformedFrameException {
        if (!FlatTable.hasIdentifier(bytes, IDENTIFIER_AT, length, FRAMES)) {
            throw new MalformedFrameException("malformed, a frame must have the identifier " + FRAMES
                    + " but had another");
        }
        try {
            FlatTable table = FlatTable.root(bytes, ROOT_AT, length);
            int format = table.byteField(FRAME_FORMAT);
            if (format != FORMAT_GREY && format != FORMAT_BGR && format != FORMAT_BGRA) {
                throw new MalformedFrameException("unsupported, a frame's format must be one of " + FORMAT_GREY + ", "
                        + FORMAT_BGR + ", " + FORMAT_BGRA + " but was " + format);
            }
            int channels = format / 8 + 1;
            int width = table.shortField(FRAME_WIDTH);
            int height = table.shortField(FRAME_HEIGHT);
            int left = table.shortField(FRAME_LEFT);
            int top = table.shortField(FRAME_TOP);
            int have = table.vectorLength(FRAME_PIXELS);
            if (width < 0 || height < 0 || have < (long) width * height * channels) {
                throw new MalformedFrameException("malformed, a frame of " + width + "x" + height + " must have "
                        + (long) width * height * channels + " bytes but had " + Integer.toUnsignedString(have));
            }
            int pixels = table.vectorAt(FRAME_PIXELS);
            byte[] levels = new byte[sensor.width() * sensor.height()];
            for (int y = Math.max(0, -top); y < Math.min(height, sensor.height() - top); y++) {
                for (int x = Math.max(0, -left); x < Math.min(width, sensor.width() - left); x++) {
                    int from = pixels + (y * width + x) * channels;
                    levels[(top + y) * sensor.width() + left + x] = channels == 1 ? bytes[from]
                            : grey(bytes[from] & 0xFF, bytes[from + 1] & 0xFF, bytes[from + 2] & 0xFF);
                }
            }
            return new GreyFrame(table.longField(FRAME_TIME, 0), sensor.width(), sensor.height(), levels);
        } catch (IndexOutOfBoundsException e) {
            throw new MalformedFrameException("malformed, a frame must lie within its " + length
                    + " bytes but points outside");
        }
    }

    /** Brightness with the weights of ITU-R BT.601. */
    private static byte grey(int blue, int green, int red) {
        return (byte) (29 * blue + 150 * green + 77 * red >> 8);
    }

    /** A frame cannot be decoded; the message is the rule that it breaks. No event is lost. */
    static final class MalformedFrameException extends Exception {
        private static final long serialVersionUID = 1L;

        MalformedFrameException(String rule) {
            super(rule);
        }
    }
}
