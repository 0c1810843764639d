package io.github.sofas.render;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;

/**
 * Paints the ground of a picture: titles, legends and empty panels. The ground stays from picture to picture, and is
 * painted again only when the speed in the legends changes.
 */
final class PanelGround {
    private static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 14);
    private static final Font TEXT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
    private static final int WHEEL_RADIUS = 24;

    private final Canvas canvas;
    private final PanelLayout layout;
    private final List<Panel> panels;
    private final Theme theme;
    private final FlowColours flowColours;
    /** Speed of the full colour that the legends show, px/s; 0 before the ground is first painted. */
    private double saidPxPerS;

    PanelGround(Canvas canvas, PanelLayout layout, List<Panel> panels, Theme theme, FlowColours flowColours) {
        this.canvas = canvas;
        this.layout = layout;
        this.panels = panels;
        this.theme = theme;
        this.flowColours = flowColours;
    }

    /** Paints the ground of the canvas for a speed of the full colour, unless the canvas already has it. */
    void paint(double fullPxPerS) {
        if (fullPxPerS == saidPxPerS) {
            return;
        }
        saidPxPerS = fullPxPerS;
        BufferedImage picture = canvas.image();
        Graphics2D g = Canvas.graphics(picture);
        g.setColor(new Color(theme.page));
        g.fillRect(0, 0, picture.getWidth(), picture.getHeight());
        for (int k = 0; k < panels.size(); k++) {
            Panel panel = panels.get(k);
            int left = layout.left(k);
            int top = layout.top(k);
            g.setColor(new Color(theme.sensor));
            g.fillRect(left, top, layout.panelWidth(), layout.panelHeight());
            g.setColor(new Color(theme.text));
            g.setFont(TITLE);
            g.drawString(panel.title, left, top - PanelLayout.BASELINE);
            g.setFont(TEXT);
            if (panel == Panel.GREY) {
                // frames cover this text
                g.drawString("no frame so far", left + PanelLayout.MARGIN, top + 2 * PanelLayout.MARGIN);
            }
            paintLegend(g, panel, left, top + layout.panelHeight() + 6);
        }
        g.dispose();
        canvas.keepAsGround();
    }

    private void paintLegend(Graphics2D g, Panel panel, int x, int y) {
        String full = String.format(Locale.ROOT, "%.0f px/s", saidPxPerS);
        switch (panel) {
            case EVENTS:
                swatch(g, x, y, theme.on, "brighter (ON)");
                swatch(g, x, y + 20, theme.off, "darker (OFF)");
                break;
            case FLOW:
                paintWheel(x + WHEEL_RADIUS, y + WHEEL_RADIUS + 1);
                g.setColor(new Color(theme.text));
                g.drawString("colour: direction of the flow", x + 58, y + 16);
                g.drawString("full colour: " + full + " or more", x + 58, y + 32);
                swatch(g, x + 58, y + 36, theme.faint, "no flow");
                break;
            case GREY:
                g.setColor(new Color(theme.text));
                g.drawString("the newest frame, its contrast stretched", x, y + 12);
                break;
            default:
                g.setColor(new Color(theme.text));
                g.drawString(panel == Panel.SEGMENTS ? "a colour and a number: one moving structure"
                    : "where each structure's next events are expected", x, y + 12);
                double bar = layout.barLength();
                SegmentArrow.draw(canvas, canvas.image().getRaster().getBounds(),
                    new Line2D.Double(x + 2, y + 28, x + 2 + bar, y + 28), SegmentArrow.WIDTH, theme.text);
                g.drawString(full, (int) (x + bar + 12), y + 33);
                swatch(g, x, y + 38, theme.faint, panel == Panel.SEGMENTS ? "no segment" : "events");
                break;
        }
    }

    private void swatch(Graphics2D g, int x, int y, int rgb, String text) {
        g.setColor(new Color(rgb));
        g.fillRect(x, y + 3, 12, 12);
        g.setColor(new Color(theme.text));
        g.drawString(text, x + 18, y + 14);
    }

    private void paintWheel(int centreX, int centreY) {
        int radius = WHEEL_RADIUS;
        for (int dy = -radius; dy <= radius; dy++) {
            for (int dx = -radius; dx <= radius; dx++) {
                if (dx * dx + dy * dy <= radius * radius) {
                    canvas.fill((centreY + dy) * canvas.width() + centreX + dx, 1, flowColours.rgb(dx, dy, radius));
                }
            }
        }
    }
}
