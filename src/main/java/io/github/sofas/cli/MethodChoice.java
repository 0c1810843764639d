package io.github.sofas.cli;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.Labelling;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.SmoothedSofas;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.Consumer;

/**
 * A method that labels events, as the user chose it: its name, its parameters, and the functions that create it.
 *
 * @param method its name on the command line
 * @param preset name of the preset that the parameters started from; empty if the method has none
 * @param parameters all parameters by the names of their options; each value is a Number, Boolean or String
 * @param maker creates the method for a sensor and for a receiver of each segment that ends
 * @param aheadMaker the same with look-ahead; null if labels are as a camera gets them
 */
record MethodChoice(String method, String preset, Map<String, Object> parameters,
                    BiFunction<SensorSize, Consumer<Segment>, EventLabeller> maker,
                    BiFunction<SensorSize, Consumer<Segment>, SmoothedSofas> aheadMaker) {

    /** A method without look-ahead. */
    MethodChoice(String method, String preset, Map<String, Object> parameters,
                 BiFunction<SensorSize, Consumer<Segment>, EventLabeller> maker) {
        this(method, preset, parameters, maker, null);
    }

    /** Whether labels wait for the events that follow. */
    boolean looksAhead() {
        return aheadMaker != null;
    }

    /** Creates the method for a sensor, with look-ahead if that was chosen. */
    Labelling labelling(SensorSize sensor, Consumer<Segment> ended) {
        return looksAhead() ? ahead(sensor, ended) : Labelling.atOnce(make(sensor, ended));
    }

    /**
     * Creates the method for the labels alone, without a receiver of segments; with look-ahead, it runs in two threads.
     */
    OpenLabelling open(SensorSize sensor) {
        if (!looksAhead()) {
            return new OpenLabelling(labelling(sensor, ended -> { }));
        }
        LookAheadInTwo inTwo = new LookAheadInTwo(ahead(sensor, ended -> { }));
        return new OpenLabelling(inTwo, inTwo::close);
    }

    /** Creates the method with the look-ahead that was chosen. */
    SmoothedSofas ahead(SensorSize sensor, Consumer<Segment> ended) {
        return aheadMaker.apply(sensor, ended);
    }

    /** Creates the method without look-ahead; {@code ended} is called for each segment that ends. */
    EventLabeller make(SensorSize sensor, Consumer<Segment> ended) {
        return maker.apply(sensor, ended);
    }
}
