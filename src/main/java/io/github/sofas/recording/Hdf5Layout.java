package io.github.sofas.recording;

import io.jhdf.HdfFile;
import io.jhdf.api.Attribute;
import io.jhdf.api.Dataset;
import io.jhdf.api.Group;
import io.jhdf.api.Node;
import io.jhdf.exceptions.HdfException;
import io.jhdf.exceptions.UnsupportedHdfException;
import java.lang.reflect.Array;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The place of the events in an HDF5 file. HDF5 is only a container, and each collection of recordings has its own
 * layout. x runs right, y down in all of them.
 *
 * @param name whose layout it is
 * @param x columns
 * @param y rows
 * @param polarity above 0 for ON
 * @param time in µs, or in s where the numbers have a fraction
 * @param timeOffsetUs offset to be added to each time, in µs
 * @param width columns of the sensor as the file states them; null where it does not
 * @param height rows likewise
 * @param usualSensor the usual sensor size of this layout, for a hint; null where there is none
 */
record Hdf5Layout(String name, Hdf5Rows.Column x, Hdf5Rows.Column y, Hdf5Rows.Column polarity, Hdf5Rows.Column time,
                  long timeOffsetUs, String width, String height, String usualSensor) {
    private static final Pattern GEOMETRY = Pattern.compile("(\\d{1,5})x(\\d{1,5})");
    private static final List<String> MVSEC = List.of("davis/left/events", "davis/right/events");

    /**
     * Finds the events.
     *
     * @throws HdfException where no known layout fits
     */
    static Hdf5Layout of(HdfFile file) {
        if (child(file, "CD/events") instanceof Dataset events) {
            Hdf5Rows rows = new Hdf5Rows(events);
            return new Hdf5Layout("Prophesee", rows.member("x"), rows.member("y"), rows.member("p"), rows.member("t"),
                    0, side(file, events, true), side(file, events, false), "1280x720");
        }
        for (String path : MVSEC) {
            if (child(file, path) instanceof Dataset events) {
                Hdf5Rows rows = matrix(events);
                return new Hdf5Layout("MVSEC", rows.column(0), rows.column(1), rows.column(3), rows.column(2), 0,
                        side(file, events, true), side(file, events, false), "346x260");
            }
        }
        Node events = child(file, "events");
        if (events instanceof Dataset) {
            Hdf5Rows rows = matrix((Dataset) events);
            return new Hdf5Layout("v2e", rows.column(1), rows.column(2), rows.column(3), rows.column(0), 0,
                    side(file, events, true), side(file, events, false), null);
        }
        if (events instanceof Group && child((Group) events, "xs") != null) {
            return columns(file, (Group) events, "RPG", "xs", "ys", "ps", "ts", null);
        }
        if (events instanceof Group) {
            return columns(file, (Group) events, "DSEC", "x", "y", "p", "t", "640x480");
        }
        throw new UnsupportedHdfException("events must be at events/x y p t (DSEC), davis/left/events (MVSEC), "
                + "CD/events (Prophesee) or events, but none are there");
    }

    private static Hdf5Layout columns(HdfFile file, Group events, String name, String x, String y, String polarity,
                                      String time, String usualSensor) {
        Node offset = child(file, "t_offset");
        long offsetUs = offset instanceof Dataset ? ((Number) first(((Dataset) offset).getData())).longValue() : 0;
        return new Hdf5Layout(name, column(events, x), column(events, y), column(events, polarity),
                column(events, time), offsetUs, side(file, events, true), side(file, events, false), usualSensor);
    }

    private static Hdf5Rows.Column column(Group events, String name) {
        if (child(events, name) instanceof Dataset dataset) {
            return new Hdf5Rows(dataset).column(0);
        }
        throw new HdfException("the group " + events.getPath() + " must have the data set " + name);
    }

    private static Hdf5Rows matrix(Dataset events) {
        Hdf5Rows rows = new Hdf5Rows(events);
        if (rows.width() != 4) {
            throw new HdfException("the data set " + events.getPath() + " must have four numbers per event but has "
                    + rows.width());
        }
        return rows;
    }

    /** The node at a path; null where there is none. */
    private static Node child(Group group, String path) {
        Node node = group;
        for (String name : path.split("/")) {
            node = node instanceof Group ? ((Group) node).getChild(name) : null;
        }
        return node;
    }

    /** Width or height of the sensor, from an attribute of the file or its events; null where neither has one. */
    private static String side(HdfFile file, Node events, boolean isWidth) {
        for (Node node : List.of(file, events)) {
            String side = side(node, isWidth);
            if (side != null) {
                return side;
            }
        }
        return null;
    }

    private static String side(Node node, boolean isWidth) {
        Attribute side = node.getAttribute(isWidth ? "width" : "height");
        if (side != null) {
            return Printable.shortened(String.valueOf(first(side.getData())));
        }
        Attribute geometry = node.getAttribute("geometry");
        if (geometry != null) {
            Matcher sides = GEOMETRY.matcher(String.valueOf(first(geometry.getData())).strip());
            return sides.matches() ? sides.group(isWidth ? 1 : 2) : null;
        }
        Attribute resolution = node.getAttribute("sensor_resolution");
        Object sides = resolution == null ? null : resolution.getData();
        return sides != null && sides.getClass().isArray() && Array.getLength(sides) == 2
                ? String.valueOf(Array.get(sides, isWidth ? 1 : 0)) : null;
    }

    private static Object first(Object value) {
        Object one = value;
        while (one != null && one.getClass().isArray() && Array.getLength(one) > 0) {
            one = Array.get(one, 0);
        }
        return one;
    }
}
