package io.github.sofas.benchmark;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries.XYSeriesRenderStyle;
import org.knowm.xchart.style.Styler.LegendLayout;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.markers.SeriesMarkers;

/**
 * Plots the engine's cost per event over the density of events, with one point per recording. The engine measures
 * motion and searches for structures per pixel of travel, so that an event of a dense scene should cost less.
 */
final class CostPlot {
    private static final int WIDTH = 720;
    private static final int HEIGHT = 440;
    private static final int PIXELS_PER_PX = 2;
    private static final int MARKER_PX = 9;
    /** Colours of Okabe and Ito's palette, which colour-blind people can distinguish. */
    private static final int[] INKS = {0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0x222222, 0xE69F00};

    private CostPlot() {
    }

    /**
     * Writes the plot as a PNG.
     *
     * @param recordings figures of each recording; a recording without flow has no density and thus no point
     */
    static void write(List<RecordingFigures> recordings, OutputStream out) throws IOException {
        BufferedImage image = new BufferedImage(WIDTH * PIXELS_PER_PX, HEIGHT * PIXELS_PER_PX,
            BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.scale(PIXELS_PER_PX, PIXELS_PER_PX);
        chart(recordings).paint(graphics, WIDTH, HEIGHT);
        graphics.dispose();
        ImageIO.write(image, "png", out);
    }

    private static XYChart chart(List<RecordingFigures> recordings) {
        XYChart chart = new XYChart(WIDTH, HEIGHT);
        chart.setTitle("Cost per event over the density");
        chart.setXAxisTitle("events while the picture travels 1 px");
        chart.setYAxisTitle("engine, ns per event");
        Font small = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
        chart.getStyler().setDefaultSeriesRenderStyle(XYSeriesRenderStyle.Scatter).setXAxisLogarithmic(true)
            .setYAxisMin(0.0).setLegendPosition(LegendPosition.OutsideS)
            .setLegendLayout(LegendLayout.Horizontal).setLegendFont(small).setChartBackgroundColor(Color.WHITE);
        chart.getStyler().setAxisTickLabelsFont(small).setAxisTitleFont(small).setMarkerSize(MARKER_PX);
        int place = 0;
        for (Map.Entry<String, List<RecordingFigures>> points : bySensor(recordings).entrySet()) {
            double[] x = points.getValue().stream().mapToDouble(each -> each.figures().eventsPerPx()).toArray();
            double[] y = points.getValue().stream().mapToDouble(each -> each.engine().cpuNsPerEvent()).toArray();
            chart.addSeries(points.getKey(), x, y).setMarker(SeriesMarkers.CIRCLE)
                .setMarkerColor(new Color(INKS[place++ % INKS.length]));
        }
        return chart;
    }

    /** Groups the recordings that have a density by the size of their sensor. */
    static Map<String, List<RecordingFigures>> bySensor(List<RecordingFigures> recordings) {
        Map<String, List<RecordingFigures>> bySensor = new LinkedHashMap<>();
        for (RecordingFigures each : recordings) {
            if (each.figures().eventsPerPx() > 0) {
                bySensor.computeIfAbsent(each.figures().sensor().toString(), sensor -> new ArrayList<>()).add(each);
            }
        }
        return bySensor;
    }
}
