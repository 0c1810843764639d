package io.github.sofas.render;

import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The arrow that shows the velocity of a segment, and the segment's name, in screen pixels. The arrow begins at the
 * segment's centre, unless the panel's edge is in the way. The name stands behind the arrow's tail, unless the edge,
 * another name or an arrow is in the way.
 */
final class SegmentArrow {
    static final double WIDTH = 2.5;
    /** Width of the outline in the text's colour. Without it, an arrow is lost on events of its own colour. */
    private static final double OUTLINE_WIDTH = 5;
    /** Width of the border in the ground's colour around the outline. */
    private static final double GROUND_WIDTH = 8;
    private static final int EDGE = 6;
    private static final int HEAD = 9;
    /** Distance from the arrow's tail to the middle of the name. */
    private static final int NAME_DISTANCE = 14;
    /**
     * Directions from the tail in which a name may stand, in turns from straight behind. The first free one is taken.
     */
    private static final double[] TURNS = {0, 0.17, -0.17, 0.33, -0.33, 0.5};

    private final int id;
    private final int rgb;
    private final int pixels;
    private final double x;
    private final double y;
    private final double lengthX;
    private final double lengthY;
    private Line2D.Double line;

    SegmentArrow(int id, int rgb, int pixels, double x, double y, double lengthX, double lengthY) {
        this.id = id;
        this.rgb = rgb;
        this.pixels = pixels;
        this.x = x;
        this.y = y;
        this.lengthX = lengthX;
        this.lengthY = lengthY;
    }

    /** Paints all arrows and names of a panel. Names of larger segments are placed first. */
    static void paint(Canvas canvas, Rectangle panel, List<SegmentArrow> arrows, Theme theme, SegmentNames names) {
        List<SegmentArrow> sorted = new ArrayList<>(arrows);
        sorted.sort(Comparator.comparingInt((SegmentArrow arrow) -> arrow.pixels).reversed());
        for (SegmentArrow each : sorted) {
            each.line = each.within(panel);
            draw(canvas, panel, each.line, GROUND_WIDTH, theme.sensor);
            draw(canvas, panel, each.line, OUTLINE_WIDTH, theme.text);
            draw(canvas, panel, each.line, WIDTH, each.rgb);
        }
        List<Rectangle> taken = new ArrayList<>();
        for (SegmentArrow each : sorted) {
            BufferedImage name = names.of(each.id, each.rgb);
            Rectangle box = each.place(name.getWidth(), name.getHeight(), panel, sorted, taken);
            taken.add(box);
            canvas.stamp(name, box.x, box.y, panel);
        }
    }

    /** The arrow, moved into the panel if it is short enough to fit. */
    private Line2D.Double within(Rectangle panel) {
        double beginX = x + shift(x, x + lengthX, panel.x, panel.x + panel.width);
        double beginY = y + shift(y, y + lengthY, panel.y, panel.y + panel.height);
        return new Line2D.Double(beginX, beginY, beginX + lengthX, beginY + lengthY);
    }

    private static double shift(double begin, double end, int low, int high) {
        double below = low + EDGE - Math.min(begin, end);
        double above = high - EDGE - Math.max(begin, end);
        return below > 0 ? below : Math.min(0, above);
    }

    /**
     * The first free place for the name around the arrow's tail, or the one behind the tail if none is free. Always in
     * the panel.
     */
    private Rectangle place(int width, int height, Rectangle panel, List<SegmentArrow> arrows, List<Rectangle> taken) {
        double behind = Math.atan2(-lengthY, -lengthX);
        Rectangle first = null;
        for (int distance = NAME_DISTANCE; distance <= 2 * NAME_DISTANCE; distance += NAME_DISTANCE) {
            for (double turn : TURNS) {
                double angle = behind + 2 * Math.PI * turn;
                int left = (int) Math.round(line.x1 + distance * Math.cos(angle) - width / 2.0);
                int top = (int) Math.round(line.y1 + distance * Math.sin(angle) - height / 2.0);
                Rectangle box = new Rectangle(Math.max(panel.x, Math.min(panel.x + panel.width - width, left)),
                    Math.max(panel.y, Math.min(panel.y + panel.height - height, top)), width, height);
                if (isFree(box, arrows, taken)) {
                    return box;
                }
                first = first == null ? box : first;
            }
        }
        return first;
    }

    private static boolean isFree(Rectangle box, List<SegmentArrow> arrows, List<Rectangle> taken) {
        for (Rectangle other : taken) {
            if (box.intersects(other)) {
                return false;
            }
        }
        for (SegmentArrow arrow : arrows) {
            if (box.intersectsLine(arrow.line)) {
                return false;
            }
        }
        return true;
    }

    /** Draws an arrow from the line's first to its second point. Arrows shorter than 3 px have no head. */
    static void draw(Canvas canvas, Rectangle clip, Line2D.Double line, double width, int rgb) {
        drawLine(canvas, clip, line, width, rgb);
        double length = Math.hypot(line.x2 - line.x1, line.y2 - line.y1);
        if (length >= 3) {
            double ux = (line.x2 - line.x1) / length;
            double uy = (line.y2 - line.y1) / length;
            double head = Math.min(HEAD, length);
            for (double side = -0.55; side < 1; side += 1.1) {
                drawLine(canvas, clip, new Line2D.Double(line.x2 - head * (ux + side * uy),
                    line.y2 - head * (uy - side * ux), line.x2, line.y2), width, rgb);
            }
        }
    }

    /**
     * Draws a line with round ends. Each pixel is painted by the share to which it lies within half the width of the
     * line.
     */
    private static void drawLine(Canvas canvas, Rectangle clip, Line2D.Double line, double width, int rgb) {
        double reach = width / 2 + 0.5;
        double dx = line.x2 - line.x1;
        double dy = line.y2 - line.y1;
        double length = Math.hypot(dx, dy);
        double perSquare = length == 0 ? 0 : 1 / (length * length);
        double left = Math.min(line.x1, line.x2) - reach;
        double right = Math.max(line.x1, line.x2) + reach;
        int bottom = (int) Math.min(clip.y + clip.height, Math.ceil(Math.max(line.y1, line.y2) + reach));
        for (int y = (int) Math.max(clip.y, Math.min(line.y1, line.y2) - reach); y < bottom; y++) {
            double fromY = y + 0.5 - line.y1;
            // only the part of each row that is near the line, however long the line may be
            double middle = line.x1 + fromY * dx / dy;
            double half = reach * length / Math.abs(dy);
            boolean isFlat = !(half < length + 2 * reach);
            int end = (int) Math.min(clip.x + clip.width, Math.ceil(isFlat ? right : Math.min(right, middle + half)));
            int x = (int) Math.max(clip.x, isFlat ? left : Math.max(left, middle - half));
            for (; x < end; x++) {
                double fromX = x + 0.5 - line.x1;
                double along = Math.max(0, Math.min(1, (fromX * dx + fromY * dy) * perSquare));
                double besideX = fromX - along * dx;
                double besideY = fromY - along * dy;
                double square = besideX * besideX + besideY * besideY;
                // lines are wider than a pixel, so that some pixels lie entirely within
                if (square <= (reach - 1) * (reach - 1)) {
                    canvas.fill(y * canvas.width() + x, 1, rgb);
                } else if (square < reach * reach) {
                    canvas.blend(y * canvas.width() + x, rgb, (int) (256 * (reach - Math.sqrt(square))));
                }
            }
        }
    }
}
