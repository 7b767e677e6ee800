package majic;

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
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Who may import whom. The house is described in docs/architecture.md. */
class ArchitectureTest {
    private static final JavaClasses CLASSES = new ClassFileImporter()
            .withImportOption(location -> !location.contains("/test-classes/"))
            .importPackages("majic", "majicsim");

    /** What each package may use of ours beside itself. A simulator may use nothing of majic: it must not share a driver's mistakes. */
    private static final Map<String, Set<String>> MAY_USE = Map.ofEntries(
            Map.entry("majic.bot", Set.of()),
            Map.entry("majic.link", Set.of()),
            Map.entry("majic.driver", Set.of("majic.bot", "majic.link")),
            Map.entry("majic.panel", Set.of("majic.bot")),
            Map.entry("majic.aibo", Set.of("majic.bot", "majic.driver", "majic.link", "majic.panel")),
            Map.entry(
                    "majic.pioneer",
                    Set.of("majic.bot", "majic.driver", "majic.link", "majic.panel", "majic.pioneer.arcos")),
            Map.entry("majic.pioneer.arcos", Set.of()),
            Map.entry("majic.hemisson", Set.of("majic.bot", "majic.driver", "majic.link", "majic.panel")),
            Map.entry("majic.act", Set.of("majic.bot")),
            Map.entry("majic.log", Set.of("majic.bot")),
            Map.entry("majic.script", Set.of("majic.bot", "majic.act", "majic.log")),
            Map.entry("majic.gui", Set.of("majic.bot", "majic.act", "majic.log", "majic.script", "majic.panel")),
            Map.entry("majicsim.world", Set.of()),
            Map.entry("majicsim.net", Set.of("majicsim.world")),
            Map.entry("majicsim.aibo", Set.of("majicsim.world", "majicsim.net", "majicsim.aibo.urbi")),
            Map.entry("majicsim.aibo.urbi", Set.of("majicsim.world", "majicsim.net")),
            Map.entry("majicsim.pioneer", Set.of("majicsim.world", "majicsim.net")),
            Map.entry("majicsim.hemisson", Set.of("majicsim.world", "majicsim.net")));

    static Set<String> packagesWithNeighbours() {
        return MAY_USE.keySet();
    }

    @ParameterizedTest
    @MethodSource("packagesWithNeighbours")
    void aPackageUsesOnlyItsNeighbours(String name) {
        Set<String> allowed = MAY_USE.get(name);
        noClasses()
                .that()
                .resideInAPackage(name)
                .should()
                .dependOnClassesThat(oursOutside(name, allowed))
                .check(CLASSES);
    }

    private static DescribedPredicate<JavaClass> oursOutside(String name, Set<String> allowed) {
        return DescribedPredicate.describe(
                "ours, but not of " + name + " or " + allowed,
                type -> (type.getPackageName().equals("majic")
                                || type.getPackageName().startsWith("majic.")
                                || type.getPackageName().startsWith("majicsim"))
                        && !type.getPackageName().equals(name)
                        && !allowed.contains(type.getPackageName()));
    }

    @Test
    void everyPackageHasItsNeighboursListed() {
        Set<String> packages = CLASSES.stream().map(JavaClass::getPackageName).collect(Collectors.toSet());
        packages.removeAll(Set.of("majic", "majicsim"));
        assertThat(MAY_USE.keySet()).containsExactlyInAnyOrderElementsOf(packages);
    }

    @Test
    void aSimulatedLabUsesNothingOfTheProgram() {
        noClasses()
                .that(resideInAPackage("majicsim.."))
                .should()
                .dependOnClassesThat(resideInAPackage("majic.."))
                .check(CLASSES);
    }

    @Test
    void onlyTheWindowAndTheRobotsPanelsTouchSwing() {
        noClasses()
                .that(resideInAPackage("majic..")
                        .and(not(resideInAnyPackage("majic.gui", "majic.panel", "majic")))
                        .and(not(panelsOfRobots())))
                .should()
                .dependOnClassesThat(
                        resideInAnyPackage("javax.swing..", "java.awt..").and(notTheReturnOfDisplay()))
                .check(CLASSES);
    }

    @Test
    void whatPanelsShareIsUsedByPanelsAndTheWindowAlone() {
        noClasses()
                .that(resideInAPackage("majic..")
                        .and(not(resideInAnyPackage("majic.panel", "majic.gui")))
                        .and(not(panelsOfRobots())))
                .should()
                .dependOnClassesThat(resideInAPackage("majic.panel"))
                .check(CLASSES);
    }

    private static DescribedPredicate<JavaClass> panelsOfRobots() {
        return DescribedPredicate.describe(
                "a robot's panel or what it draws with",
                type -> type.getName().matches(".*(Panel|Drawing|Picture|Numbers|Lights|Button)(\\$.*)?"));
    }

    private static DescribedPredicate<JavaClass> notTheReturnOfDisplay() {
        return DescribedPredicate.describe(
                "other than JComponent", type -> !type.getName().equals("javax.swing.JComponent"));
    }

    @Test
    void noTwoPackagesUseEachOther() {
        slices().matching("(majic*.*)..").should().beFreeOfCycles().check(CLASSES);
    }
}
