package io.github.sofas.experiments;

import io.github.sofas.baseline.LocalPlanes;
import io.github.sofas.baseline.LucasKanade;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import java.util.function.Function;

/** A method that takes part in every experiment: a preset of SOFAS, or another method to compare SOFAS with. */
public enum ComparedMethod {
    /** SOFAS with the most accurate preset. */
    SOFAS_DEFAULT("sofas-default", "SOFAS, default", true,
        sensor -> new Sofas(sensor, SofasParameters.defaults())),
    /** SOFAS as published. */
    SOFAS_PAPER("sofas-paper", "SOFAS, paper", true, sensor -> new Sofas(sensor, SofasParameters.paper())),
    /** Lucas-Kanade for events with Savitzky-Golay derivatives, the better of the variants. */
    LUCAS_KANADE("lucas-kanade", "Lucas-Kanade", false, LucasKanade::new),
    /** Local plane fitting. */
    LOCAL_PLANES("local-planes", "Local planes", false, LocalPlanes::new);

    private final String id;
    private final String title;
    private final boolean segmenting;
    private final Function<SensorSize, EventLabeller> maker;

    ComparedMethod(String id, String title, boolean segmenting, Function<SensorSize, EventLabeller> maker) {
        this.id = id;
        this.title = title;
        this.segmenting = segmenting;
        this.maker = maker;
    }

    /** Name of the method in the CSV files. */
    public String id() {
        return id;
    }

    /** Name of the method for people. */
    public String title() {
        return title;
    }

    /** Whether the method finds segments; the others give segment 1 to every event with flow. */
    boolean segmenting() {
        return segmenting;
    }

    /** Makes the method with its own defaults. */
    EventLabeller make(SensorSize sensor) {
        return maker.apply(sensor);
    }
}
