package io.github.sofas;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.methods;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.junit.Assert.assertEquals;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.Test;

/** Holds the arrows between the packages: who may see whom. */
public class ArchitectureTest {
    private static final String ROOT = "io.github.sofas";

    /** For each package the packages of ours that it may see besides itself. A new package is entered here. */
    private static final Map<String, Set<String>> MAY_SEE = Map.ofEntries(
        Map.entry("event", Set.of()),
        Map.entry("flow", Set.of("event")),
        Map.entry("recording", Set.of("event")),
        Map.entry("live", Set.of("event", "recording")),
        Map.entry("batch", Set.of()),
        Map.entry("host", Set.of("event", "flow")),
        Map.entry("export", Set.of("event", "flow")),
        Map.entry("render", Set.of("event", "flow")),
        Map.entry("report", Set.of("event", "flow", "export", "render", "evaluate")),
        Map.entry("baseline", Set.of("event", "flow")),
        Map.entry("simulate", Set.of("event")),
        Map.entry("evaluate", Set.of("event", "flow", "recording", "export", "baseline", "simulate")),
        Map.entry("experiments", Set.of("event", "flow", "recording", "export", "render", "baseline", "simulate",
            "evaluate")),
        Map.entry("benchmark", Set.of("event", "flow", "recording", "export", "simulate")),
        Map.entry("cli", Set.of("event", "flow", "recording", "live", "host", "batch", "export", "render",
            "report", "baseline", "simulate", "evaluate", "experiments", "benchmark")));

    /** For each room of flow the rooms that it may see besides itself. */
    private static final Map<String, Set<String>> ROOMS = Map.of(
        "motion", Set.of(),
        "fit", Set.of("motion"),
        "search", Set.of("motion", "fit"),
        "track", Set.of("motion", "fit"),
        "smooth", Set.of("motion", "fit"),
        "paper", Set.of("motion"));

    /** What the rooms see of flow itself: the words of the API, not what wires the rooms. */
    private static final Set<String> WORDS = Set.of("SofasParameters", "Parameter", "FlowOutput", "Segment",
        "PixelConsumer");

    /** Functions of {@link Math} whose results may differ in the last bit from machine to machine. */
    private static final Set<String> LEFT_TO_THE_MACHINE = Set.of("sin", "cos", "tan", "asin", "acos", "atan", "atan2",
        "sinh", "cosh", "tanh", "exp", "expm1", "log", "log10", "log1p", "pow", "cbrt");

    private static final JavaClasses MAIN = new ClassFileImporter()
        .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
        .importPackages(ROOT);

    @Test
    public void everyPackageSeesOnlyWhatItsArrowsAllow() {
        MAY_SEE.forEach((name, seen) -> {
            String[] allowed = new TreeSet<>(seen).stream().map(ArchitectureTest::packages).toArray(String[]::new);
            noClasses().that().resideInAPackage(packages(name))
                .should().dependOnClassesThat(resideInAPackage(ROOT + "..")
                    .and(not(resideInAPackage(packages(name))))
                    .and(not(resideInAnyPackage(allowed))))
                .allowEmptyShould(true)
                .because(name + " may see " + new TreeSet<>(seen))
                .check(MAIN);
        });
    }

    @Test
    public void everyRoomOfFlowSeesOnlyWhatItsArrowsAllow() {
        DescribedPredicate<JavaClass> words = DescribedPredicate.describe("the words of the API",
            type -> type.getPackageName().equals(ROOT + ".flow")
                && WORDS.contains(type.getName().substring((ROOT + ".flow.").length()).split("\\$")[0]));
        ROOMS.forEach((name, seen) -> {
            String[] allowed = new TreeSet<>(seen).stream().map(room -> packages("flow." + room))
                .toArray(String[]::new);
            noClasses().that().resideInAPackage(packages("flow." + name))
                .should().dependOnClassesThat(resideInAPackage(packages("flow"))
                    .and(not(resideInAPackage(packages("flow." + name))))
                    .and(not(resideInAnyPackage(allowed)))
                    .and(not(words)))
                .because("flow." + name + " may see " + new TreeSet<>(seen) + " and " + new TreeSet<>(WORDS))
                .check(MAIN);
        });
    }

    @Test
    public void everyRoomOfFlowHasItsArrows() {
        Set<String> rooms = new TreeSet<>();
        for (JavaClass type : MAIN) {
            if (type.getPackageName().startsWith(ROOT + ".flow.")) {
                rooms.add(type.getPackageName().substring((ROOT + ".flow.").length()));
            }
        }
        assertEquals(new TreeSet<>(ROOMS.keySet()), rooms);
    }

    @Test
    public void roomsOfFlowAreSeenFromFlowOnly() {
        noClasses().that().resideOutsideOfPackage(packages("flow"))
            .should().dependOnClassesThat(resideInAPackage(packages("flow"))
                .and(not(resideInAPackage(ROOT + ".flow"))))
            .because("what is public there is public for the other rooms only, and no part of the API")
            .check(MAIN);
    }

    @Test
    public void everyPackageHasItsArrows() {
        Set<String> unknown = new TreeSet<>();
        for (JavaClass type : MAIN) {
            String inside = type.getPackageName().substring(ROOT.length()).replaceFirst("^\\.", "");
            String top = inside.split("\\.")[0];
            if (!MAY_SEE.containsKey(top)) {
                unknown.add(type.getName());
            }
        }
        assertEquals("classes in packages without an entry in MAY_SEE", Set.of(), unknown);
    }

    @Test
    public void eventAndFlowNeedNothingButTheLanguage() {
        classes().that().resideInAnyPackage(packages("event"), packages("flow"))
            .should().onlyDependOnClassesThat(resideInAnyPackage(
                packages("event"), packages("flow"), "java.lang..", "java.util", "java.util.function"))
            .andShould().onlyDependOnClassesThat(not(resideInAnyPackage("java.util.zip..", "java.lang.foreign..")))
            .because("the core is pure computation that any program can embed")
            .check(MAIN);
    }

    @Test
    public void whatLabelsOrSimulatesComputesAlikeOnEveryMachine() {
        noClasses().that().resideInAnyPackage(packages("flow"), packages("baseline"), packages("simulate"))
            .should().callMethodWhere(DescribedPredicate.describe("the last bits of Math are left to the machine",
                call -> call.getTargetOwner().isEquivalentTo(Math.class)
                    && LEFT_TO_THE_MACHINE.contains(call.getName())))
            .because("the same input gives the same bytes; StrictMath does")
            .check(MAIN);
    }

    @Test
    public void everyTestIsInAClassThatTheBuildRuns() {
        JavaClasses all = new ClassFileImporter().importPackages(ROOT);
        methods().that().areAnnotatedWith(Test.class)
            .should().beDeclaredInClassesThat().haveSimpleNameEndingWith("Test")
            .because("gradle/java.gradle selects tests by this name")
            .check(all);
    }

    private static String packages(String name) {
        return ROOT + "." + name + "..";
    }
}
