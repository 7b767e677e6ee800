package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import majic.bot.BotAddress;
import majic.bot.ConnectFailed;
import majic.bot.Pose;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.inlab.LabRig;
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
}
