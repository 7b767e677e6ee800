package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.List;
import majic.bot.BotAddress;
import majic.bot.ConnectFailed;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.pioneer.MajicPioneer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** The driver over a real serial port of the system, with a RoadNarrows robot at the other end. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no pseudo-terminals that are serial ports")
class MajicHemissonOnAPortTest {
    private final PortHemisson robot = PortHemisson.roadNarrows();
    private final MajicHemisson bot = new MajicHemisson(
            new BotAddress("hemisson", robot.name()), new BotEnvironment(robot.time(), Settings.inMemory()));

    @BeforeEach
    void plugIn() {
        bot.connect();
    }

    @AfterEach
    void unplug() {
        bot.close();
        robot.close();
    }

    @Test
    void aMotionIsConfirmedByTheRoadNarrowsFirmware() {
        bot.move(10);

        assertThat(bot.get("version")).hasToString("HemiOS_v_1.50-RNe");
        assertThat(robot.heard()).containsSubsequence("D,2,2", "D,0,0", "E");
    }

    @Test
    void modulesAreReadByTheCommandsOfTheRoadNarrowsFirmware() {
        assertThat(bot.get("modules")).hasToString("ultrasonic sensor at E0, linear camera at C0");
        assertThat(bot.get("ultrasonic")).hasToString("320 mm");
        assertThat(bot.get("ultrasonicEchoes")).hasToString("320 mm, 650 mm");
        assertThat(bot.get("camera").toString()).startsWith("0, 255, 0, 255");
    }

    @Test
    void anAdapterPulledOutWhileItMovesIsReportedWithTheRemedy() {
        robot.pullWhenItMoves();

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(LinkLost.class)
                .hasMessageContaining("the serial port " + robot.name() + " is gone")
                .hasMessageContaining("lift it");
    }

    @Test
    void aSecondDriverFailsBecauseThePortIsInUse() {
        assertFindsThePortBusy(new MajicHemisson("hemisson:" + robot.name()));
        assertFindsThePortBusy(new MajicPioneer("pioneer:" + robot.name()));
        bot.move(5);
        assertThat(bot.isConnected()).isTrue();
    }

    private static void assertFindsThePortBusy(MajicBot second) {
        try (second) {
            ConnectFailed failure = catchThrowableOfType(ConnectFailed.class, second::connect);

            assertThat(failure.reason()).isEqualTo(ConnectFailed.Reason.BUSY);
            assertThat(failure).hasMessageContaining("already; is a robot connected to it?");
        }
    }

    @Test
    void closingStopsItAndConfirmsTheStop() {
        bot.drive(42, 0);
        robot.awaitMotion();

        bot.close();

        List<String> afterMotion = robot.heard()
                .subList(robot.heard().indexOf("D,3,3") + 1, robot.heard().size());
        assertThat(afterMotion)
                .filteredOn(command -> !command.startsWith("N"))
                .as(
                        "a stop and the question for the speeds; the stop may be repeated if the first one is confirmed early")
                .startsWith("D,0,0", "E")
                .isSubsetOf("D,0,0", "E");
    }
}
