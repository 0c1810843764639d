package io.github.sofas.render;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The arrow of a segment, along its velocity, and its name, in screen pixels. The arrow begins at the segment's centre
 * and the name stands behind it, unless that is beyond the panel's edge or in the way of others.
 */
final class SegmentArrow {
    private static final int EDGE = 6;
    private static final int HEAD = 9;
    /** From the arrow's tail to the middle of the name. */
    private static final int NAME_DISTANCE = 14;
    /** Where a name may stand, as turns from behind the tail; the first that is free. */
    private static final double[] TURNS = {0, 0.17, -0.17, 0.33, -0.33, 0.5};

    private final int id;
    private final Color colour;
    private final int pixels;
    private final double x;
    private final double y;
    private final double lengthX;
    private final double lengthY;
    private Line2D.Double line;

    SegmentArrow(int id, int rgb, int pixels, double x, double y, double lengthX, double lengthY) {
        this.id = id;
        colour = new Color(rgb);
        this.pixels = pixels;
        this.x = x;
        this.y = y;
        this.lengthX = lengthX;
        this.lengthY = lengthY;
    }

    /** Paints all of a panel; names of larger segments find their place first. */
    static void paint(Graphics2D g, Rectangle panel, List<SegmentArrow> arrows, int ground, SegmentNames names) {
        List<SegmentArrow> sorted = new ArrayList<>(arrows);
        sorted.sort(Comparator.comparingInt((SegmentArrow arrow) -> arrow.pixels).reversed());
        for (SegmentArrow each : sorted) {
            each.line = each.within(panel);
            g.setColor(new Color(ground));
            g.setStroke(new BasicStroke(6, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            draw(g, each.line);
            g.setColor(each.colour);
            g.setStroke(new BasicStroke(2.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            draw(g, each.line);
        }
        List<Rectangle> taken = new ArrayList<>();
        for (SegmentArrow each : sorted) {
            BufferedImage name = names.of(each.id, each.colour.getRGB());
            Rectangle box = each.place(name.getWidth(), name.getHeight(), panel, sorted, taken);
            taken.add(box);
            g.drawImage(name, box.x, box.y, null);
        }
    }

    /** The arrow, moved so that it is in the panel where it is short enough. */
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

    /** The first free place for the name about the arrow's tail, else the one behind it; in the panel. */
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
                if (taken.stream().noneMatch(box::intersects) && arrows.stream().noneMatch(arrow ->
                        box.intersectsLine(arrow.line))) {
                    return box;
                }
                first = first == null ? box : first;
            }
        }
        return first;
    }

    /** An arrow from the line's first to its second point; short ones are only a line. */
    static void draw(Graphics2D g, Line2D.Double line) {
        Path2D path = new Path2D.Double(line);
        double length = Math.hypot(line.x2 - line.x1, line.y2 - line.y1);
        if (length >= 3) {
            double ux = (line.x2 - line.x1) / length;
            double uy = (line.y2 - line.y1) / length;
            double head = Math.min(HEAD, length);
            path.moveTo(line.x2 - head * ux - head * 0.55 * uy, line.y2 - head * uy + head * 0.55 * ux);
            path.lineTo(line.x2, line.y2);
            path.lineTo(line.x2 - head * ux + head * 0.55 * uy, line.y2 - head * uy - head * 0.55 * ux);
        }
        g.draw(path);
    }
}
