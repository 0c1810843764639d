package io.github.sofas.experiments;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.Function;
import javax.imageio.ImageIO;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.XYSeries.XYSeriesRenderStyle;
import org.knowm.xchart.style.Styler.LegendLayout;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Draws plots, histograms and metric maps as pictures, each for a light and a dark page. */
final class Charts {
    private static final int PIXELS_PER_PX = 2;
    private static final Color CLEAR = new Color(0, 0, 0, 0);

    /** The colours of a page. The inks are of Okabe and Ito's palette, which colour-blind people can distinguish. */
    private enum Theme {
        LIGHT(0x222222, 0xDDDDDD, new int[] {0x222222, 0x0072B2, 0x009E73, 0xD55E00, 0xB0559A},
            new int[] {0x0072B2, 0xD55E00, 0x009E73, 0xB0559A, 0x8A6D00, 0x2E9AD0}),
        DARK(0xE6E6E6, 0x3A3F45, new int[] {0xFFFFFF, 0x56B4E9, 0x2FC79C, 0xFF8A4C, 0xE39BCB},
            new int[] {0x56B4E9, 0xFF8A4C, 0x2FC79C, 0xE39BCB, 0xF0E442, 0x9BD3F5});

        private final Color text;
        private final Color grid;
        private final int[] inks;
        private final int[] byPlace;

        Theme(int text, int grid, int[] inks, int[] byPlace) {
            this.text = new Color(text);
            this.grid = new Color(grid);
            this.inks = inks;
            this.byPlace = byPlace;
        }

        Color of(Plot.Ink ink, int place) {
            return new Color(ink == Plot.Ink.BY_PLACE ? byPlace[place % byPlace.length] : inks[ink.ordinal()]);
        }
    }

    private Charts() {
    }

    /** Draws a plot with a legend. */
    static Picture of(Plot plot, int width, int height) {
        return picture(theme -> {
            XYChart chart = chart(theme, width, height, plot.title(), plot.xTitle(), plot.yTitle());
            chart.getStyler().setLegendVisible(plot.lines().size() > 1).setLegendPosition(LegendPosition.OutsideS)
                .setLegendLayout(LegendLayout.Horizontal);
            for (int i = 0; i < plot.lines().size(); i++) {
                Plot.Line line = plot.lines().get(i);
                XYSeries series = chart.addSeries(line.name(), withHalfStep(line.x()),
                    with(Double.NaN, line.y()));
                series.setMarker(SeriesMarkers.NONE);
                series.setLineColor(theme.of(line.ink(), i));
                series.setLineStyle(new BasicStroke(line.ink() == Plot.Ink.TRUTH ? 2.4f : 1.4f));
            }
            return chart;
        }, width, height, plot.title() + ": " + plot.yTitle() + " over " + plot.xTitle());
    }

    /**
     * Adds a first point half a step earlier, where nothing is drawn. Without that point, XChart puts the ticks on
     * evenly spaced values themselves, however odd the values are.
     */
    private static double[] withHalfStep(double[] x) {
        return with(x.length < 2 ? x[0] : 1.5 * x[0] - 0.5 * x[1], x);
    }

    private static double[] with(double first, double[] values) {
        double[] longer = new double[values.length + 1];
        System.arraycopy(values, 0, longer, 1, values.length);
        longer[0] = first;
        return longer;
    }

    /** Draws a histogram of errors. */
    static Picture of(Histogram histogram, String title, String xTitle, Plot.Ink ink, int width, int height) {
        int bins = histogram.counts().length;
        double[] x = new double[bins + 2];
        double[] y = new double[bins + 2];
        for (int b = 0; b < bins; b++) {
            x[b] = histogram.from(b);
            y[b] = histogram.percent(b);
        }
        // half a bin, for XChart's ticks, as in withHalfStep
        x[bins] = histogram.middle(bins - 1);
        y[bins] = y[bins - 1];
        x[bins + 1] = histogram.limit();
        return picture(theme -> {
            XYChart chart = chart(theme, width, height, title, xTitle, "events, %");
            chart.getStyler().setLegendVisible(false);
            chart.getStyler().setXAxisMin(-histogram.limit()).setXAxisMax(histogram.limit()).setYAxisMin(0.0);
            Color colour = theme.of(ink, 0);
            XYSeries series = chart.addSeries(title, x, y);
            series.setXYSeriesRenderStyle(XYSeriesRenderStyle.StepArea).setMarker(SeriesMarkers.NONE);
            series.setLineColor(colour).setFillColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(),
                120));
            series.setLineStyle(new BasicStroke(1));
            return chart;
        }, width, height, "Histogram, " + title + ", " + xTitle);
    }

    /** Draws a metric map, darker where the metric is higher as in the paper, with the velocities of the two axes. */
    static Picture of(MetricMap map, String title, int side) {
        BufferedImage cells = cells(map);
        int margin = 46;
        int all = side + margin + 12;
        byte[][] images = new byte[Theme.values().length][];
        for (Theme theme : Theme.values()) {
            BufferedImage image = new BufferedImage(all * PIXELS_PER_PX, all * PIXELS_PER_PX,
                BufferedImage.TYPE_INT_ARGB);
            Graphics2D graphics = graphics(image);
            graphics.drawImage(cells, margin, 10, side, side, null);
            graphics.setColor(theme.text);
            graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 11));
            graphics.drawRect(margin, 10, side, side);
            for (int pxPerS : new int[] {-400, -150, -50, 0, 50, 150, 400}) {
                int at = (int) Math.round(MetricMap.place(pxPerS) * side);
                String label = Integer.toString(pxPerS);
                int labelWidth = graphics.getFontMetrics().stringWidth(label);
                graphics.drawLine(margin + at, 10 + side, margin + at, 14 + side);
                graphics.drawString(label, margin + at - labelWidth / 2, 26 + side);
                graphics.drawLine(margin - 4, 10 + at, margin, 10 + at);
                graphics.drawString(label, margin - 7 - labelWidth, 14 + at);
            }
            graphics.drawString("vx, px/s", margin + side / 2 - 22, 42 + side);
            graphics.rotate(-Math.PI / 2);
            graphics.drawString("vy, px/s", -side / 2 - 32, 11);
            graphics.dispose();
            images[theme.ordinal()] = png(image);
        }
        return new Picture(images[0], images[1], all, all, title);
    }

    /** Draws one pixel per projection, darker where the metric is higher. */
    static BufferedImage cells(MetricMap map) {
        BufferedImage cells = new BufferedImage(map.n(), map.n(), BufferedImage.TYPE_INT_RGB);
        long least = Long.MAX_VALUE;
        long most = Long.MIN_VALUE;
        for (long[] row : map.metrics()) {
            for (long metric : row) {
                least = Math.min(least, metric);
                most = Math.max(most, metric);
            }
        }
        for (int row = 0; row < map.n(); row++) {
            for (int column = 0; column < map.n(); column++) {
                double share = (double) (map.metrics()[row][column] - least) / Math.max(1, most - least);
                // the square root brings out the ridges, which are far below the peak
                int grey = (int) Math.round(255 * (1 - Math.sqrt(share)));
                cells.setRGB(column, row, grey << 16 | grey << 8 | grey);
            }
        }
        return cells;
    }

    /** Makes a picture of a light and a dark image of the same thing, unchanged. */
    static Picture of(BufferedImage light, BufferedImage dark, String alt) {
        return new Picture(png(light), png(dark), light.getWidth() / PIXELS_PER_PX, light.getHeight() / PIXELS_PER_PX,
            alt);
    }

    private static XYChart chart(Theme theme, int width, int height, String title, String xTitle, String yTitle) {
        XYChart chart = new XYChart(width, height);
        chart.setTitle(title);
        chart.setXAxisTitle(xTitle);
        chart.setYAxisTitle(yTitle);
        XYStyler styler = chart.getStyler();
        Font small = new Font(Font.SANS_SERIF, Font.PLAIN, 10);
        styler.setChartBackgroundColor(CLEAR).setPlotBackgroundColor(CLEAR).setLegendBackgroundColor(CLEAR)
            .setLegendBorderColor(CLEAR).setPlotBorderColor(theme.grid).setChartFontColor(theme.text)
            .setChartTitleFontColor(theme.text).setXAxisTitleColor(theme.text).setYAxisTitleColor(theme.text)
            .setChartTitleBoxVisible(false).setChartTitlePadding(4).setChartPadding(4).setLegendPadding(6)
            .setLegendSeriesLineLength(14).setLegendFont(small)
            .setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 11));
        styler.setAxisTickLabelsFont(small).setAxisTitleFont(small).setAxisTickLabelsColor(theme.text)
            .setAxisTickMarksColor(theme.grid).setPlotGridLinesColor(theme.grid).setAxisTitlePadding(3)
            .setXAxisTickMarkSpacingHint(50).setYAxisTickMarkSpacingHint(30);
        return chart;
    }

    private static Picture picture(Function<Theme, XYChart> charts, int width, int height, String alt) {
        byte[][] images = new byte[Theme.values().length][];
        for (Theme theme : Theme.values()) {
            BufferedImage image = new BufferedImage(width * PIXELS_PER_PX, height * PIXELS_PER_PX,
                BufferedImage.TYPE_INT_ARGB);
            Graphics2D graphics = graphics(image);
            charts.apply(theme).paint(graphics, width, height);
            graphics.dispose();
            images[theme.ordinal()] = png(image);
        }
        return new Picture(images[Theme.LIGHT.ordinal()], images[Theme.DARK.ordinal()], width, height, alt);
    }

    /** Returns graphics that draw in px of the page on an image of finer resolution. */
    private static Graphics2D graphics(BufferedImage image) {
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.scale(PIXELS_PER_PX, PIXELS_PER_PX);
        return graphics;
    }

    private static byte[] png(BufferedImage image) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "png", bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
