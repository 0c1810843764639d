package io.github.sofas.benchmark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.Arrays;
import java.util.Map;
import org.junit.Test;

public class StageTest {
    /** A stack of frames such as "flow.FlowPlane.settle", innermost first. */
    private static Stage of(String... frames) {
        return Stage.of(Arrays.stream(frames).map(frame -> {
            int dot = frame.lastIndexOf('.');
            String type = frame.substring(0, dot);
            return new StackTraceElement(type.startsWith("java.") ? type : "io.github.sofas." + type,
                frame.substring(dot + 1), null, -1);
        }).toArray(StackTraceElement[]::new));
    }

    @Test
    public void whatServesSeveralStagesCountsForItsCaller() {
        assertEquals(Stage.RE_CENTRING, of("flow.fit.MetricFit.metric", "flow.track.TrackPlane.measure",
            "flow.track.TrackPlane.recentre", "flow.track.TrackPlaneStack.label", "flow.RefinedMethod.label"));
        assertEquals(Stage.FLOW_PLANE, of("flow.fit.MetricFit.metric", "flow.search.StructureSearch.refine",
            "flow.RefinedMethod.label"));
        assertEquals(Stage.OUTPUT, of("java.io.FileOutputStream.write", "export.FlowCsvWriter.write",
            "benchmark.Benchmark.run"));
    }

    @Test
    public void aTrackPlaneThatTheFlowPlaneStartsIsTheFlowPlanesWork() {
        assertEquals(Stage.FLOW_PLANE, of("flow.track.TrackPlane.recentre", "flow.track.TrackPlaneStack.begin",
            "flow.search.StructureSearch.run", "flow.RefinedMethod.label"));
    }

    @Test
    public void whatATrackPlaneDoesWithoutMeasuringIsMatching() {
        assertEquals(Stage.MATCHING, of("flow.track.Contour.support", "flow.track.TrackPlaneStack.label",
            "flow.Sofas.process"));
        assertEquals(Stage.MATCHING, of("flow.paper.TrackPlane.offer", "flow.PaperMethod.label"));
        assertEquals(Stage.MATCHING, of("flow.Sofas.process", "benchmark.Benchmark.run"));
    }

    @Test
    public void theRestIsOther() {
        assertEquals(Stage.DECODING, of("java.nio.Bits.get", "recording.Aedat2Reader.decode"));
        assertEquals(Stage.OTHER, of("benchmark.Benchmark.run"));
        assertEquals(Stage.OTHER, of());
    }

    @Test
    public void theNamesGoneByAreThoseOfTheEngine() {
        JavaClasses engine = new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .importPackages("io.github.sofas.flow");
        for (String name : new String[] {"search.FlowPlane", "paper.FlowPlane",
            "search.StructureSearch", "track.TrackPlane", "paper.TrackPlane"}) {
            assertTrue(name, engine.contain("io.github.sofas.flow." + name));
        }
        for (String name : new String[] {"track.TrackPlane", "paper.TrackPlane"}) {
            assertTrue(name, engine.get("io.github.sofas.flow." + name).getMethods().stream()
                .anyMatch(method -> method.getName().equals("recentre")));
        }
    }

    @Test
    public void sharesAreOfAllThatWasSeen() {
        // decoding, matching, re-centring, flow plane, output, other
        assertEquals(Map.of(Stage.DECODING, 0.0, Stage.MATCHING, 0.25, Stage.RE_CENTRING, 0.125,
            Stage.FLOW_PLANE, 0.5, Stage.OUTPUT, 0.125, Stage.OTHER, 0.0),
            StageSampler.shares(new long[] {0, 2, 1, 4, 1, 0}));
        assertEquals(Map.of(), StageSampler.shares(new long[6]));
    }
}
