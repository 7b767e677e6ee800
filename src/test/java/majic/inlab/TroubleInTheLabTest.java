package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.List;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.link.Loopback;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests robots that are absent, refuse, stop sending or disconnect while they drive. */
class TroubleInTheLabTest {
    @ParameterizedTest
    @ValueSource(strings = {"aibo", "pioneer", "hemisson"})
    void aMissingRobotIsReported(String type) {
        int port = Loopback.freePort();
        try (LabRig rig = LabRig.exact()) {
            MajicBot bot = rig.session().factory().create(type + ":tcp://127.0.0.1:" + port);

            assertThatThrownBy(bot::connect)
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining("nothing listens at 127.0.0.1 port " + port);
            bot.close();
        }
    }

    @ParameterizedTest
    @CsvSource({"aibo, 6", "pioneer, 8", "hemisson, 5"})
    void connectingToASilentPeerFailsInTime(String type, double boundSeconds) throws IOException {
        try (LabRig rig = LabRig.exact();
                ServerSocket mute = new ServerSocket(0, 50, InetAddress.getLoopbackAddress())) {
            BotEnvironment onLabTime = new BotEnvironment(rig.lab().time(), Settings.inMemory());
            long before = rig.lab().time().nanos();
            BotAddress address = new BotAddress(type, "tcp://127.0.0.1:" + mute.getLocalPort());
            MajicBot bot = rig.session().factory().type(type).create(address, onLabTime);

            assertThatThrownBy(bot::connect).isInstanceOf(BotException.class).hasMessageMatching("(?s).{20,}");
            assertThat(rig.lab().time().secondsSince(before)).isLessThan(boundSeconds);
            bot.close();
        }
    }

    @ParameterizedTest
    @CsvSource({"1, aibo", "2, pioneer", "3, hemisson"})
    void aLinkThatDropsMidMotionIsReportedAndTheOthersGoOn(int number, String type) throws InterruptedException {
        try (LabRig rig = LabRig.exact().withAllRobots()) {
            rig.lab()
                    .time()
                    .thread("fault", () -> {
                        sleep(rig, 2);
                        rig.lab().simulators().faults(type).cut();
                    })
                    .start();

            List<String> said = rig.run("1 move 300", "2 move 800", "3 move 150");

            assertThat(said).anyMatch(line -> line.startsWith(number + " move") && line.contains("failed: "));
            assertThat(said).filteredOn(line -> line.contains(": done (")).hasSize(2);
        }
    }

    private static void sleep(LabRig rig, double seconds) {
        try {
            rig.lab().time().sleep(seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void connectingMovesNothingAndSwitchesNoMotorsOn() throws InterruptedException {
        try (LabRig rig = LabRig.exact().withAllRobots()) {
            rig.lab().time().sleep(5);

            assertThat(rig.run("2 get motors")).containsExactly("2 motors = no");
            assertThat(rig.run("1 get motors")).containsExactly("1 motors = no");
        }
    }
}
