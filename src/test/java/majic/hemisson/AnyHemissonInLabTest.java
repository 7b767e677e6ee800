package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.contains;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.verify;

import java.util.List;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.MajicBot;
import majic.bot.Value;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests the driver with all kinds of Hemissons: real receivers that lose bytes, modules, both firmwares, special modes.
 */
class AnyHemissonInLabTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "kteam+camera+ultrasonic+speech+lcd+io+overrun+paced",
                "roadnarrows+camera+ultrasonic+speech+overrun+paced"
            })
    void noCommandBlocksItsReceiver(String model) throws Exception {
        try (LabRig rig = LabRig.exactWithHemisson(model)) {
            MajicBot bot = rig.add("hemisson");
            bot.parameters().forEach(parameter -> read(bot, parameter.name()));
            bot.move(60, () -> bot.get("light0").number() < 1);
            bot.parameters().forEach(parameter -> read(bot, parameter.name()));

            assertThat(bot.get("modules").toString()).contains("linear camera", "ultrasonic sensor");
            assertThat(((Value.Many) bot.get("camera")).values()).hasSize(102);
            assertThat(bot.get("ultrasonic").number()).isGreaterThan(30);
            assertThat(bot.get("missedAnswers").number()).isZero();
        }
    }

    /** Reads a parameter, unless it can only be set. */
    private static void read(MajicBot bot, String parameter) {
        if (bot.parameter(parameter).readable()) {
            assertThat(bot.get(parameter)).isNotNull();
        }
    }

    @Test
    void aGuardReadsTheUltrasonicSensorWhileItMoves() throws Exception {
        try (LabRig rig = LabRig.exactWithHemisson("kteam+ultrasonic+overrun+paced")) {
            MajicBot bot = rig.add("hemisson");
            double start = bot.get("ultrasonic").number();

            bot.move(1000, () -> bot.get("ultrasonic").number() < start - 30);

            assertThat(bot.get("x").number()).as("from %s", start).isBetween(15.0, 100.0);
        }
    }

    @Test
    void modulesOfRoadNarrowsAreSwitchedByTheirOwnCommands() throws Exception {
        try (LabRig rig = LabRig.exactWithHemisson("roadnarrows+camera+ultrasonic+speech")) {
            MajicBot bot = rig.add("hemisson");
            assertThat(bot.get("cameraLight")).hasToString("unknown (not set since it was connected)");

            assertThat(rig.run("1 set cameraLight on", "1 set ultrasonicRange 1000", "1 phrase 7"))
                    .allMatch(line -> !line.contains("failed"));

            assertThat(bot.get("cameraLight").isYes()).isTrue();
            assertThat(bot.get("ultrasonicRange")).hasToString("1000 mm");
            assertThat(bot.get("speaking").isYes()).isTrue();
            rig.lab()
                    .simulators()
                    .besideHemisson(person -> assertThat(person.said()).containsExactly("phrase 7"));
        }
    }

    @Test
    void aDancingRobotCausesAWarningAndItsMotionEndsWithTheReason() throws Exception {
        try (LabRig rig = LabRig.exactWithHemisson("kteam+switches=1011+overrun")) {
            MajicBot bot = rig.session().factory().create("sim:hemisson");
            BotListener listener = mock();
            bot.addListener(listener);
            bot.connect();

            verify(listener).notice(any(), contains("[1, 0, 1, 1]"));
            assertThatThrownBy(() -> bot.move(500))
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining("mode \"dance\"")
                    .hasMessageContaining("switch it off and on");
            bot.close();
        }
    }

    @ParameterizedTest
    @CsvSource({"1110, obstacle avoidance", "1101, line following", "1011, dance"})
    void aStopAndAMoveOfARobotWithAModeOfItsOwnNameTheMode(String switches, String mode) throws Exception {
        try (LabRig rig = LabRig.exactWithHemisson("kteam+overrun+switches=" + switches)) {
            rig.add("hemisson");

            for (String line : List.of("1 stop", "1 move 60", "1 stop", "1 drive 50 0 for 1s")) {
                assertThat(rig.run(line))
                        .filteredOn(answer -> answer.startsWith(line))
                        .hasSize(1)
                        .first()
                        .asString()
                        .startsWith(line + ": failed: it runs in the mode \"" + mode);
            }
        }
    }

    @Test
    void aPinThatWasSetKeepsItsLevelThoughItIsReadAllTheWhile() throws Exception {
        try (LabRig rig = LabRig.exactWithHemisson("kteam")) {
            MajicBot bot = rig.add("hemisson");
            rig.lab().simulators().besideHemisson(person -> person.pinInput(0, false));
            bot.get("pinRB0");
            bot.set("pinRB0", "on");
            for (int look = 0; look < 40; look++) {
                assertThat(bot.get("pinRB0").isYes()).isTrue();
                rig.lab().time().sleep(0.1);
            }

            rig.lab()
                    .simulators()
                    .besideHemisson(person -> assertThat(person.pinLevel(0)).isTrue());
        }
    }

    @Test
    void aRobotWithoutAModeIsNotDeafened() throws Exception {
        try (LabRig rig = LabRig.exactWithHemisson("kteam+switches=0000+overrun")) {
            MajicBot bot = rig.add("hemisson");

            assertThatThrownBy(() -> bot.move(100))
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining("no running mode");
            bot.stop();
            rig.lab().time().sleep(3);

            assertThat(bot.isConnected()).isTrue();
            assertThat(bot.get("switches")).hasToString("0, 0, 0, 0");
        }
    }

    @Test
    void aRobotThatPullsToOneSideGoesStraightWhenItsTrimIsSet() throws Exception {
        try (LabRig rig = LabRig.exactWithHemisson("kteam+mismatch=5")) {
            MajicBot bot = rig.add("hemisson");
            double before = rig.truePose("hemisson").headingDeg();
            bot.set("trim", 5);

            bot.move(600);

            assertThat(rig.truePose("hemisson").headingDeg() - before).isCloseTo(0, within(3.0));
        }
    }
}
