/**
 * Pictures of events, flow and segments. Open {@link io.github.sofas.render.PictureSheet} first: it takes labelled
 * events and paints them at any time, as panels side by side with their legends. The sheet remembers the last event of
 * every pixel, so that its memory does not grow with the recording: it takes 53 bytes per pixel of the sensor and 9 per
 * pixel of the picture. A film takes up to 12 bytes per pixel of the picture and one megabyte, whatever its length.
 *
 * <pre>{@code
 * PictureSheet sheet = new PictureSheet(sensor, PictureOptions.defaults());
 * sheet.add(batch, flow, 0, batch.size());
 * BufferedImage picture = sheet.paint(timeUs, timeUs - firstUs, null); // a Sofas engine in place of null for contours
 * }</pre>
 *
 * <p>{@link io.github.sofas.render.FlowColours} and {@link io.github.sofas.render.SegmentColours} define the
 * colours; {@link io.github.sofas.render.Film} makes MP4, GIF or PNG files of pictures.
 */
package io.github.sofas.render;
