package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import majic.bot.BotAddress;
import majic.bot.BotCommand;
import majic.bot.ConnectFailed;
import majic.bot.Pose;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Several robots behind one rosbridge server. */
class RosTeamInLabTest {
    private static LabRig withTwo(String version) {
        LabRig rig = LabRig.exactWithRos(version + "+robots=2");
        rig.add("ros");
        rig.add("ros2");
        return rig;
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2"})
    void eachObeysItsOwnCommands(String version) throws InterruptedException {
        try (LabRig rig = withTwo(version)) {
            Pose first = rig.truePose("ros");
            Pose second = rig.truePose("ros2");

            rig.run("1 move 200");
            assertThat(rig.truePose("ros").distanceMm(first)).isBetween(190.0, 210.0);
            assertThat(rig.truePose("ros2")).isEqualTo(second);

            rig.run("2 turn 90");
            assertThat(rig.truePose("ros2").distanceMm(second)).isLessThan(10);
            assertThat(Pose.normalised(rig.truePose("ros2").headingDeg() - second.headingDeg() - 90))
                    .isBetween(-1.0, 1.0);
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2"})
    void stopStopsAll(String version) throws InterruptedException {
        try (LabRig rig = withTwo(version)) {
            Pose start = rig.truePose("ros");
            Pose otherStart = rig.truePose("ros2");
            rig.say("all move 800");
            rig.lab().time().sleep(1);
            assertThat(rig.truePose("ros").distanceMm(start)).isGreaterThan(50);
            assertThat(rig.truePose("ros2").distanceMm(otherStart)).isGreaterThan(50);
            rig.run("stop");
            rig.lab().time().sleep(0.5);
            Pose first = rig.truePose("ros");
            Pose second = rig.truePose("ros2");
            rig.lab().time().sleep(2);

            assertThat(rig.truePose("ros")).isEqualTo(first);
            assertThat(rig.truePose("ros2")).isEqualTo(second);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"ros", "pioneer"})
    void theNameOfARobotOfTheLabIsAnsweredWithItsAddress(String name) {
        try (LabRig rig = LabRig.exactWithRos("1")) {
            rig.say("add " + name);

            assertThat(rig.said()).containsExactly(name + ": not a robot's address; did you mean sim:" + name + "?");
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2"})
    void anAddressWithoutANamespaceIsAnsweredWithThoseThatThereAre(String version) {
        try (LabRig rig = LabRig.exactWithRos(version + "+robots=2")) {
            String address = rig.lab().address("ros").orElseThrow().toString();
            String server = address.substring(0, address.lastIndexOf('/'));
            MajicRos robot = new MajicRos(
                    BotAddress.parse(server), new BotEnvironment(rig.lab().time(), Settings.inMemory()));

            assertThatThrownBy(robot::connect)
                    .isInstanceOf(ConnectFailed.class)
                    .hasMessage("there are 2 robots behind " + server + "; is it " + server + "/tb3_0 or " + server
                            + "/tb3_1?");
            robot.close();
        }
    }

    @Test
    void aBaseHasOneIdentityWhateverItsAddressSays() {
        try (LabRig rig = LabRig.exactWithRos("1+robots=2")) {
            String address = rig.lab().address("ros").orElseThrow().toString();
            String other = rig.lab().address("ros2").orElseThrow().toString();
            String server = address.substring(0, address.lastIndexOf('/'));

            assertThat(Stream.of(
                                    address,
                                    address + "/",
                                    server + "//tb3_0",
                                    server + "?base=/tb3_0/odom",
                                    server + "?base=tb3_0/cmd_vel",
                                    address + "?base=/tb3_0")
                            .map(each -> identity(rig, each)))
                    .containsOnly(identity(rig, address));
            assertThat(identity(rig, address)).isPresent().isNotEqualTo(identity(rig, other));
        }
    }

    private static Optional<String> identity(LabRig rig, String address) {
        try (MajicRos robot = new MajicRos(
                BotAddress.parse(address), new BotEnvironment(rig.lab().time(), Settings.inMemory()))) {
            robot.connect();
            return robot.identity();
        }
    }

    @Test
    void aServerInTheNamespaceOfTheRobotIsFound() {
        try (LabRobot robot = new LabRobot("ros", LabRig.exactWithRos("2+namespace=tb3+server=tb3"))) {
            robot.bot().connect();

            assertThat(robot.bot().introduction()).contains("ROS 2 humble", "/tb3/cmd_vel");
            assertThat(robot.bot().run("topics", List.of())).contains("/tb3/odom");
            assertThat(robot.bot().commands()).extracting(BotCommand::name).contains("goto");
            assertThat(robot.bot().move(100).amount().number()).isBetween(90.0, 110.0);
        }
    }
}
