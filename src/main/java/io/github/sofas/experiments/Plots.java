package io.github.sofas.experiments;

import io.github.sofas.evaluate.ConvergenceBin;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** Makes the plots of the simulated experiments: the pendulum's speed, and the convergence on each shape. */
final class Plots {
    /** Least number of events with flow in a bin of the convergence for which its error is drawn. */
    private static final int FEWEST_EVENTS = 5;

    private Plots() {
    }

    /** All curves of the page, for CSV. */
    static List<Plot> all(Experiments experiments) {
        List<Plot> plots = new ArrayList<>(pendulum(experiments));
        for (Setting setting : Setting.SHAPES) {
            plots.add(convergenceOfError(experiments, setting));
            plots.add(convergenceOfShare(experiments, setting));
        }
        experiments.real().forEach(real -> plots.addAll(real.plots()));
        return plots;
    }

    /** The pendulum's speed, one plot per method. */
    static List<Plot> pendulum(Experiments experiments) {
        List<Plot> plots = new ArrayList<>();
        for (ComparedMethod method : ComparedMethod.values()) {
            Trial trial = experiments.trial(Setting.PENDULUM, method);
            plots.add(new Plot("pendulum-" + method.id(), method.title(), "time, s", "median speed, px/s", List.of(
                new Plot.Line("true", Plot.Ink.TRUTH, trial.trueSpeed()),
                new Plot.Line(method.title(), Plot.Ink.of(method), trial.speed()))));
        }
        return plots;
    }

    /** Mean relative endpoint error over the time since the object appeared. */
    static Plot convergenceOfError(Experiments experiments, Setting setting) {
        return convergence(experiments, setting, "convergence-error-" + setting.id(), setting.title(),
            "mean endpoint error, %", bin -> bin.eventsWithFlow() < FEWEST_EVENTS ? Double.NaN
                : bin.meanRelativeEndpointErrorPercent());
    }

    /** Share of the object's events with flow over the same time. */
    static Plot convergenceOfShare(Experiments experiments, Setting setting) {
        return convergence(experiments, setting, "convergence-share-" + setting.id(), setting.title(),
            "object events with flow, %", bin -> bin.events() == 0 ? Double.NaN : 100 * bin.shareWithFlow());
    }

    private static Plot convergence(Experiments experiments, Setting setting, String id, String title, String yTitle,
                                    ToDoubleFunction<ConvergenceBin> y) {
        List<Plot.Line> lines = new ArrayList<>();
        for (ComparedMethod method : ComparedMethod.values()) {
            List<ConvergenceBin> bins = experiments.trial(setting, method).evaluation().convergence();
            lines.add(new Plot.Line(method.title(), Plot.Ink.of(method),
                bins.stream().mapToDouble(bin -> (bin.fromUs() + bin.untilUs()) / 2e3).toArray(),
                bins.stream().mapToDouble(y).toArray()));
        }
        return new Plot(id, title, "time since appearance, ms", yTitle, lines);
    }
}
