package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Test;

/** What the CONFIG packet says about sonars and the watchdog. */
class ReportedEquipmentTest {
    private final ScriptedPioneer robot = ScriptedPioneer.robot();

    private static boolean has(MajicBot bot, String parameter) {
        return bot.parameters().stream().map(Parameter::name).anyMatch(parameter::equals);
    }

    @Test
    void sonarsThatAreNotThereAreAbsent() {
        robot.frontSonar = 0;
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(has(stage.bot, "distanceFront")).isFalse();
            assertThat(has(stage.bot, "sonar0")).isFalse();
            assertThat(stage.bot.get("distanceBack")).hasToString("clear");
            assertThat(stage.bot.get("distanceLeft")).hasToString("clear");
            assertThat(stage.bot.get("sonar15")).hasToString("clear");
            assertThatThrownBy(() -> stage.bot.get("sonarPower2")).hasMessageContaining("no such parameter");
        }
    }

    @Test
    void aRobotWithoutAnySonarHasNoneOfTheirParameters() {
        robot.frontSonar = 0;
        robot.rearSonar = 0;
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(stage.bot.parameters())
                    .extracting(Parameter::name)
                    .noneMatch(name -> name.startsWith("sonar") || name.startsWith("distance"));
            assertThat(robot.heard).doesNotContain("SONAR 1");
        }
    }

    @Test
    void aControllerWithoutAWatchdogIsNoticed() {
        robot.watchdogMs = 0;
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(stage.bot.get("watchdog")).hasToString("never");
            assertThat(stage.notices).anyMatch(notice -> notice.contains("its watchdog is off"));
        }
    }

    @Test
    void aUsualWatchdogIsShownWithoutANotice() {
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(stage.bot.get("watchdog")).hasToString("2000 ms");
            assertThat(stage.notices).noneMatch(notice -> notice.contains("watchdog"));
        }
    }

    @Test
    void aScriptThatUsesAnAbsentSonarIsRefused() throws InterruptedException {
        try (LabRig rig = LabRig.exactWithPioneer("p3dx-sh+nofrontsonar")) {
            rig.add("pioneer");

            assertThat(rig.run("1 move 100 until distanceFront < 300"))
                    .anyMatch(line -> line.contains("distanceFront") && line.contains("no such parameter"));
        }
    }

    @Test
    void theLabHasARobotWithoutAWatchdog() {
        try (LabRig rig = LabRig.exactWithPioneer("p3dx-sh+nowatchdog")) {
            assertThat(rig.add("pioneer").get("watchdog")).hasToString("never");
        }
    }

    @Test
    void neverIsInNoOrderWithATime() throws InterruptedException {
        try (LabRig rig = LabRig.exactWithPioneer("p3dx-sh+nowatchdog")) {
            rig.add("pioneer");

            assertThat(rig.run("if 1 watchdog < 5000 then { echo short } else { echo longer }"))
                    .noneMatch(line -> line.contains("short"));
        }
    }
}
