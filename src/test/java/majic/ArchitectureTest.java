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

/** Tests which package may import which, as described in docs/architecture.md. */
class ArchitectureTest {
    private static final JavaClasses CLASSES = new ClassFileImporter()
            .withImportOption(location -> !location.contains("/test-classes/"))
            .importPackages("majic", "majicsim");

    /**
     * Maps each package to the project's packages that it may use besides itself. A simulator must not use majic, so
     * that it cannot share a driver's defects.
     */
    private static final Map<String, Set<String>> MAY_USE = table("""
            majic.bot                 : majic.time majic.text
            majic.link                :
            majic.driver              : majic.bot majic.link majic.time
            majic.panel               : majic.bot
            majic.panel.map           : majic.bot majic.panel
            majic.aibo                : majic.bot majic.driver majic.link majic.time majic.aibo.body majic.aibo.panel \
                                        majic.aibo.parameters majic.aibo.session majic.aibo.sound majic.aibo.urbi
            majic.aibo.urbi           : majic.bot majic.driver majic.link majic.time
            majic.aibo.body           : majic.bot majic.aibo.urbi
            majic.aibo.session        : majic.bot majic.driver majic.link majic.time majic.aibo.body majic.aibo.urbi
            majic.aibo.sound          : majic.bot majic.time majic.aibo.session majic.aibo.urbi majic.text
            majic.aibo.parameters     : majic.bot majic.driver majic.time majic.aibo.body majic.aibo.session \
                                        majic.aibo.sound majic.aibo.urbi
            majic.aibo.panel          : majic.bot majic.time majic.team majic.panel majic.aibo.body majic.aibo.urbi
            majic.pioneer             : majic.bot majic.link majic.time majic.pioneer.arcos majic.pioneer.panel \
                                        majic.pioneer.parameters majic.pioneer.session majic.pioneer.state
            majic.pioneer.arcos       :
            majic.pioneer.state       : majic.bot majic.pioneer.arcos
            majic.pioneer.session     : majic.bot majic.driver majic.link majic.time majic.pioneer.arcos \
                                        majic.pioneer.state
            majic.pioneer.parameters  : majic.bot majic.driver majic.time majic.pioneer.arcos majic.pioneer.session \
                                        majic.pioneer.state
            majic.pioneer.panel       : majic.bot majic.panel majic.panel.map majic.pioneer.arcos majic.pioneer.state
            majic.hemisson            : majic.bot majic.driver majic.time majic.hemisson.line majic.hemisson.modules \
                                        majic.hemisson.motion majic.hemisson.panel majic.hemisson.parameters \
                                        majic.hemisson.readings
            majic.hemisson.line       : majic.bot majic.driver majic.link majic.time
            majic.hemisson.readings   : majic.bot majic.time majic.hemisson.line
            majic.hemisson.motion     : majic.bot majic.driver majic.time majic.hemisson.line majic.hemisson.readings
            majic.hemisson.modules    : majic.bot majic.time majic.hemisson.line majic.hemisson.readings
            majic.hemisson.parameters : majic.bot majic.hemisson.line majic.hemisson.modules majic.hemisson.motion \
                                        majic.hemisson.readings
            majic.hemisson.panel      : majic.bot majic.panel majic.panel.map majic.hemisson.line \
                                        majic.hemisson.readings
            majic.act                 : majic.bot majic.time majic.team majic.text
            majic.log                 : majic.bot majic.time majic.team majic.text
            majic.script              : majic.bot majic.time majic.team majic.act majic.log majic.act.file \
                                        majic.script.actions majic.script.acts majic.script.conditions \
                                        majic.script.help majic.script.lines majic.script.record majic.script.run \
                                        majic.script.syntax majic.text
            majic.script.lines        : majic.bot majic.time majic.team majic.log majic.script.conditions \
                                        majic.script.run majic.script.syntax
            majic.script.actions      : majic.bot majic.time majic.lab majic.team majic.log majic.script.conditions \
                                        majic.script.help majic.script.record majic.script.run majic.script.syntax \
                                        majic.text
            majic.script.acts         : majic.bot majic.team majic.act majic.script.conditions majic.script.record \
                                        majic.script.run majic.script.syntax
            majic.script.run          : majic.bot majic.time majic.team majic.act majic.log majic.script.conditions \
                                        majic.script.record majic.script.syntax majic.text
            majic.script.conditions   : majic.bot majic.team majic.script.syntax
            majic.script.record       : majic.time majic.team
            majic.script.help         : majic.bot majic.lab majic.team majic.script.syntax majic.text
            majic.script.syntax       : majic.bot majic.text
            majic.gui                 : majic.bot majic.lab majic.team majic.log majic.panel.map majic.script \
                                        majic.gui.acts majic.gui.add majic.gui.bots majic.gui.command majic.gui.kit \
                                        majic.gui.map
            majicsim.world            :
            majicsim.net              : majicsim.world
            majicsim.aibo             : majicsim.aibo.urbi majicsim.aibo.urbi.memory majicsim.aibo.urbi.run \
                                        majicsim.aibo.urbi.value majicsim.net majicsim.world
            majicsim.aibo.urbi        : majicsim.aibo.urbi.command majicsim.aibo.urbi.memory majicsim.aibo.urbi.run \
                                        majicsim.aibo.urbi.syntax majicsim.aibo.urbi.value majicsim.net \
                                        majicsim.world
            majicsim.aibo.urbi.command : majicsim.aibo.urbi.assign majicsim.aibo.urbi.flow majicsim.aibo.urbi.memory \
                                        majicsim.aibo.urbi.run majicsim.aibo.urbi.syntax majicsim.aibo.urbi.value
            majicsim.aibo.urbi.flow   : majicsim.aibo.urbi.memory majicsim.aibo.urbi.run majicsim.aibo.urbi.syntax \
                                        majicsim.aibo.urbi.value
            majicsim.aibo.urbi.assign : majicsim.aibo.urbi.memory majicsim.aibo.urbi.run majicsim.aibo.urbi.syntax \
                                        majicsim.aibo.urbi.value
            majicsim.aibo.urbi.run    : majicsim.aibo.urbi.memory majicsim.aibo.urbi.syntax majicsim.aibo.urbi.value
            majicsim.aibo.urbi.memory : majicsim.aibo.urbi.value
            majicsim.aibo.urbi.syntax : majicsim.aibo.urbi.value
            majicsim.aibo.urbi.value  :
            majicsim.pioneer          : majicsim.net majicsim.pioneer.board majicsim.pioneer.devices \
                                        majicsim.pioneer.model majicsim.pioneer.serial majicsim.pioneer.session \
                                        majicsim.world
            majicsim.pioneer.session  : majicsim.net majicsim.pioneer.board majicsim.pioneer.devices \
                                        majicsim.pioneer.model majicsim.pioneer.motion majicsim.pioneer.packet \
                                        majicsim.pioneer.ranging majicsim.pioneer.report majicsim.world
            majicsim.pioneer.serial   : majicsim.net majicsim.pioneer.devices
            majicsim.pioneer.report   : majicsim.pioneer.board majicsim.pioneer.devices majicsim.pioneer.model \
                                        majicsim.pioneer.motion majicsim.pioneer.packet majicsim.pioneer.ranging \
                                        majicsim.world
            majicsim.pioneer.board    : majicsim.pioneer.devices majicsim.pioneer.model majicsim.pioneer.motion \
                                        majicsim.pioneer.ranging majicsim.world
            majicsim.pioneer.ranging  : majicsim.pioneer.model majicsim.world
            majicsim.pioneer.devices  : majicsim.pioneer.model majicsim.pioneer.packet majicsim.world
            majicsim.pioneer.motion   : majicsim.pioneer.model majicsim.world
            majicsim.pioneer.model    :
            majicsim.pioneer.packet   :
            majicsim.hemisson         : majicsim.hemisson.behaviour majicsim.hemisson.board \
                                        majicsim.hemisson.firmware majicsim.hemisson.modules \
                                        majicsim.hemisson.options majicsim.hemisson.uart majicsim.net majicsim.world
            majicsim.hemisson.firmware : majicsim.hemisson.board majicsim.hemisson.modules majicsim.hemisson.uart
            majicsim.hemisson.behaviour : majicsim.hemisson.board majicsim.hemisson.options
            majicsim.hemisson.board   : majicsim.world
            majicsim.hemisson.uart    : majicsim.hemisson.options majicsim.net
            majicsim.hemisson.options : majicsim.hemisson.modules
            majicsim.hemisson.modules : majicsim.world
            majic.cli                 : majic.bot majic.act majic.script majic.act.file majic.act.make majic.console \
                                        majic.program majic.server majic.simulation majicsim \
                                        majicsim.hemisson.options majicsim.pioneer majicsim.world
            majic.console             : majic.bot majic.act majic.log majic.script majic.act.file majic.program
            majic.lab                 : majic.bot majic.time
            majic.program             : majic.bot majic.link majic.time majic.team majic.log majic.script \
                                        majic.act.file majic.gui majic.gui.kit majic.server majic.simulation \
                                        majic.text majicsim
            majic.server              : majic.log majic.script
            majic.simulation          : majic.bot majic.link majic.time majic.lab majicsim majicsim.net \
                                        majicsim.world
            majic.team                : majic.bot majic.time majic.lab majic.text
            majic.time                :
            majic.act.file            : majic.bot majic.act majic.text
            majic.act.make            : majic.act majic.act.file
            majic.gui.acts            : majic.bot majic.time majic.team majic.act majic.script majic.act.file \
                                        majic.act.make majic.gui.kit majic.text
            majic.gui.add             : majic.bot majic.lab majic.team majic.script majic.gui.kit majic.text
            majic.gui.bots            : majic.bot majic.team majic.gui.acts majic.gui.drive majic.gui.kit
            majic.gui.command         : majic.log majic.script majic.gui.kit
            majic.gui.drive           : majic.bot majic.team
            majic.gui.kit             : majic.bot majic.team majic.panel
            majic.gui.map             : majic.bot majic.lab majic.team majic.panel majic.panel.map majic.gui.kit
            majic.text                :
            """);

    private static Map<String, Set<String>> table(String rows) {
        return rows.lines()
                .map(row -> row.split("\\s*:\\s*", -1))
                .collect(Collectors.toMap(
                        row -> row[0], row -> Set.of(row[1].isBlank() ? new String[0] : row[1].split("\\s+"))));
    }

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
                        .and(not(resideInAnyPackage(
                                "majic.gui..", "majic.panel..", "majic.program", "majic.cli", "majic")))
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
                        .and(not(resideInAnyPackage("majic.panel..", "majic.gui..")))
                        .and(not(panelsOfRobots())))
                .should()
                .dependOnClassesThat(resideInAPackage("majic.panel.."))
                .check(CLASSES);
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
        slices().matching("(majic*.*)..").should().beFreeOfCycles().check(CLASSES);
    }
}
