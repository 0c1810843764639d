package io.github.sofas.cli;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * Parameters of earlier versions, which were options and keys of config files. Using one is an error whose message says
 * what became of it.
 */
final class RemovedParameters {
    private static final Map<String, String> REASONS = new LinkedHashMap<>();

    static {
        constant("range-deg", "180 degrees");
        constant("refinement", "9");
        constant("cycles", "3");
        constant("flow-travel-px", "6 px");
        constant("slowest-within", "0.03");
        constant("max-lifetime-us", "1 s");
        constant("steady-px", "0.15 px");
        constant("hit-share", "0.1");
        constant("min-perturbation-deg", "0.05 degrees");
        constant("max-perturbation-deg", "4 degrees");
        constant("contour-threshold", "3");
        constant("contour-share", "0.15");
        constant("max-memory-us", "2 s");
        constant("vote-cell-px", "1.3 px");
        constant("sample-events", "1000");
        constant("sample-density", "1.5");
        constant("neighbour-loss", "0.04");
        constant("min-step-px", "0.5 px");
        constant("max-step-px", "4 px");
        constant("flat-sigmas", "2");
        constant("stiffness", "0.002");
        constant("shared-score", "0.25");
        constant("max-bend-px", "0.25 px");
        constant("flat-change", "0.1");
        constant("change-px", "1.5 px");
        constant("change-gain", "0.5");
        constant("bend-px", "0.07 px");
        constant("flat-decay", "0.05");
        constant("max-shared", "0.15");
        constant("merge-velocity", "0.15");
        constant("merge-loss", "0.02");
        constant("merge-gap-share", "0.8");
        REASONS.put("foresight", "acceleration=false replaces 0");
        for (String name : new String[] {"path-px", "crowded-share", "slow-share", "return-share", "pair-gap-share"}) {
            REASONS.put(name, "it had no measurable effect");
        }
    }

    private RemovedParameters() {
    }

    private static void constant(String name, String value) {
        REASONS.put(name, "it is always " + value);
    }

    /** Names of all removed parameters, as options without dashes. */
    static Set<String> names() {
        return REASONS.keySet();
    }

    /** Says what became of a parameter, beginning with its name. */
    static String message(String name) {
        return name + " was removed: " + REASONS.get(name) + "; see CHANGELOG.md";
    }
}
