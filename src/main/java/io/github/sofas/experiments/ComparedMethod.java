package io.github.sofas.experiments;

import io.github.sofas.baseline.LocalPlanes;
import io.github.sofas.baseline.LucasKanade;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import java.util.function.Function;

/** A method that takes part in every experiment. */
public enum ComparedMethod {
    /** SOFAS with the preset that is most accurate. */
    SOFAS_DEFAULT("sofas-default", "SOFAS, default", true,
        sensor -> new Sofas(sensor, SofasParameters.defaults())),
    /** SOFAS as published. */
    SOFAS_PAPER("sofas-paper", "SOFAS, paper", true, sensor -> new Sofas(sensor, SofasParameters.paper())),
    /** Lucas-Kanade for events with Savitzky-Golay derivatives, the better of its variants. */
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

    /** Its name in the CSV files. */
    public String id() {
        return id;
    }

    /** Its name for people. */
    public String title() {
        return title;
    }

    /** Whether it finds segments; the others give segment 1 to every event with flow. */
    boolean segmenting() {
        return segmenting;
    }

    /** Makes it with its own defaults. */
    EventLabeller make(SensorSize sensor) {
        return maker.apply(sensor);
    }
}
