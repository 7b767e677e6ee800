package majic.build;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/**
 * Tests which package uses which, as listed and drawn in docs/architecture.md. One object of the class holds all
 * classes of the project, so that its memory is free for the tests that follow.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class ArchitectureTest {
    private final JavaClasses classes = new ClassFileImporter()
            .withImportOption(location -> !location.contains("/test-classes/"))
            .importPackages("majic", "majicsim");

    /** What each package uses of the project's other packages, each with one class that does. */
    private final Map<String, Map<String, String>> uses = uses();

    private Map<String, Map<String, String>> uses() {
        Map<String, Map<String, String>> all = new TreeMap<>();
        for (JavaClass type : classes) {
            Map<String, String> used = all.computeIfAbsent(type.getPackageName(), name -> new TreeMap<>());
            type.getDirectDependenciesFromSelf().stream()
                    .map(dependency ->
                            dependency.getTargetClass().getBaseComponentType().getPackageName())
                    .filter(name -> name.matches("majic(sim)?(\\..*)?") && !name.equals(type.getPackageName()))
                    .forEach(name -> used.putIfAbsent(name, type.getSimpleName()));
        }
        return all;
    }

    @Test
    void theTablesOfThePageHaveARowForEachPackage() {
        assertThat(ArchitecturePage.table().keySet()).isEqualTo(uses.keySet());
    }

    @Test
    void aPackageUsesExactlyThePackagesInItsRow() {
        List<String> changes = new ArrayList<>();
        ArchitecturePage.table().forEach((name, allowed) -> {
            Map<String, String> used = uses.getOrDefault(name, Map.of());
            used.forEach((other, user) -> {
                if (!allowed.contains(other)) {
                    changes.add("row %s: add `%s` (%s uses it)"
                            .formatted(name, ArchitecturePage.abbreviated(other, name), user));
                }
            });
            allowed.stream()
                    .filter(other -> !used.containsKey(other))
                    .forEach(other -> changes.add("row %s: remove `%s` (no class uses it)"
                            .formatted(name, ArchitecturePage.abbreviated(other, name))));
        });
        assertThat(changes).as("changes to the tables in docs/architecture.md").isEmpty();
    }

    @Test
    void theDiagramsShowWhatFollowsFromTheTables() {
        List<String> changes = new ArrayList<>();
        ArchitecturePage.diagrams().forEach((name, lines) -> {
            List<String> expected = ArchitecturePage.diagram(name, ArchitecturePage.table());
            lines.stream()
                    .filter(line -> !expected.contains(line))
                    .forEach(line -> changes.add("diagram of " + name + ": remove " + line));
            expected.stream()
                    .filter(line -> !lines.contains(line))
                    .forEach(line -> changes.add("diagram of " + name + ": add " + line));
        });
        assertThat(changes)
                .as("changes to the diagrams in docs/architecture.md")
                .isEmpty();
    }

    @Test
    void eachPackageWithFiveOrMoreDirectlyBelowItHasADiagram() {
        Map<String, Long> below = uses.keySet().stream()
                .filter(name -> name.contains("."))
                .collect(Collectors.groupingBy(
                        name -> name.substring(0, name.lastIndexOf('.')), TreeMap::new, Collectors.counting()));
        below.values().removeIf(count -> count < 5);
        assertThat(ArchitecturePage.diagrams().keySet()).isEqualTo(below.keySet());
    }

    @Test
    void aSimulatedLabUsesNothingOfTheProgram() {
        noClasses()
                .that(resideInAPackage("majicsim.."))
                .should()
                .dependOnClassesThat(resideInAPackage("majic.."))
                .check(classes);
    }

    /** Maps are pictures, and Java decodes PNG into an image of AWT, which needs no window. */
    @Test
    void onlyTheWindowAndTheRobotsPanelsTouchSwing() {
        noClasses()
                .that(resideInAPackage("majic..")
                        .and(not(resideInAnyPackage(
                                "majic.gui..",
                                "majic.panel..",
                                "majic.program",
                                "majic.cli",
                                "majic",
                                "majic.nav.file")))
                        .and(not(panelsOfRobots())))
                .should()
                .dependOnClassesThat(
                        resideInAnyPackage("javax.swing..", "java.awt..").and(notTheReturnOfDisplay()))
                .check(classes);
    }

    @Test
    void whatPanelsShareIsUsedByPanelsAndTheWindowAlone() {
        noClasses()
                .that(resideInAPackage("majic..")
                        .and(not(resideInAnyPackage("majic.panel..", "majic.gui..")))
                        .and(not(panelsOfRobots())))
                .should()
                .dependOnClassesThat(resideInAPackage("majic.panel.."))
                .check(classes);
    }

    private static DescribedPredicate<JavaClass> panelsOfRobots() {
        return DescribedPredicate.describe(
                "a robot's panel or what it draws with",
                type -> type.getPackageName().matches("majic\\.[a-z]+\\.panel")
                        || type.getName().matches(".*(Panel|Drawing|Picture|Numbers|Lights|Button)(\\$.*)?"));
    }

    private static DescribedPredicate<JavaClass> notTheReturnOfDisplay() {
        return DescribedPredicate.describe(
                "other than JComponent", type -> !type.getName().equals("javax.swing.JComponent"));
    }

    @Test
    void noTwoPackagesUseEachOther() {
        slices().matching("(majic*.*)..").should().beFreeOfCycles().check(classes);
    }
}
