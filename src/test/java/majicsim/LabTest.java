package majicsim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.StringReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.Locale;
import java.util.Set;
import majicsim.net.Client;
import majicsim.net.LineCount;
import majicsim.world.Pose;
import majicsim.world.Room;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

@Timeout(value = 180, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class LabTest {
    @AutoClose
    private Lab lab;

    @BeforeEach
    void open() throws IOException {
        lab = Lab.open(LabOptions.exactOnFreePorts());
    }

    @Test
    void itsClockAdvancesOnlyInSteps() {
        assertThat(lab.nanos()).isZero();
        lab.step();
        assertThat(lab.nanos()).isEqualTo(Lab.STEP_NANOS);
    }

    @Test
    void aRobotCommandedOverItsLineMovesInTheRoom() throws IOException {
        Pose before = lab.truePoses().get("hemisson");
        try (Client client = new Client(lab.addresses().get("hemisson"))) {
            client.send("D,5,5\r");
            assertThat(client.read(3)).isEqualTo("d\r\n");
            steps(250);
        }
        assertThat(lab.truePoses().get("hemisson").distanceTo(before)).isCloseTo(86, within(1e-6));
    }

    @Test
    void furtherPioneersStartApartFromTheOtherRobots() throws IOException {
        try (Lab many = Lab.open(LabOptions.exactOnFreePorts().withPioneers(3))) {
            assertThat(many.addresses()).containsKeys("pioneer", "pioneer2", "pioneer3");
            assertThat(many.truePoses().keySet())
                    .containsExactly("aibo", "pioneer", "hemisson", "pioneer2", "pioneer3");
            assertThat(many.truePoses()
                            .get("pioneer2")
                            .distanceTo(many.truePoses().get("pioneer3")))
                    .isGreaterThan(600);
        }
    }

    @Test
    void aNoisyLabWithTheSameSeedIsTheSameLabAgain() throws IOException {
        Pose first = poseAfterDriving(7);
        assertThat(poseAfterDriving(7)).isEqualTo(first);
        assertThat(poseAfterDriving(8)).isNotEqualTo(first);
    }

    @Test
    void aRobotIsPlacedOnlyWhereItFits() {
        Pose free = new Pose(1500, 800, 45);
        lab.place("hemisson", free);
        assertThat(lab.truePoses()).containsEntry("hemisson", free);
        assertThatThrownBy(() -> lab.place("hemisson", new Pose(4490, 0, 0))).hasMessageContaining("does not fit");
        assertThatThrownBy(() -> lab.place("hal", free)).hasMessageStartingWith("the lab has no robot hal; it has ");
    }

    @Test
    void theRobotsComeInTheOrderOfTheirNumbers() {
        assertThat(lab.truePoses().keySet()).containsExactly("aibo", "pioneer", "hemisson");
        assertThat(lab.addresses().keySet()).containsSubsequence("aibo", "pioneer", "hemisson");
    }

    @Test
    void theRobotsWithASerialPlugHaveAPseudoTerminalWhereThereAreAny() {
        assertThat(lab.addresses().keySet())
                .isIn(
                        Set.of("aibo", "pioneer", "pioneer-pty", "hemisson", "hemisson-pty"),
                        Set.of("aibo", "pioneer", "hemisson"));
    }

    @ParameterizedTest
    @MethodSource("majicsim.pioneer.PioneerRobot#models")
    void everyPioneerFindsItsPlaceInTheStandardRoom(String model) throws IOException {
        try (Lab other = Lab.open(LabOptions.exactOnFreePorts().withPioneer(model.toUpperCase(Locale.ROOT)))) {
            assertThat(other.truePoses()).containsKey("pioneer");
        }
    }

    @Test
    void aPioneerThatDoesNotExistIsRefusedWithThoseThatDo() {
        assertThatThrownBy(() -> LabOptions.exactOnFreePorts().withPioneer("p4"))
                .hasMessageStartingWith("there is no Pioneer model 'p4'; known are p3dx, p3dx-sh, ");
    }

    @Test
    void theStandardRoomHasItsWalls() {
        assertThat(lab.walls()).hasSize(22);
    }

    @Test
    void aTakenPortThatWasWishedForIsAnError() throws IOException {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            int port = taken.getLocalPort();
            LabOptions wish = LabOptions.exactOnFreePorts().withPorts(new LabPorts(0, 0, port, 0, 0));
            assertThatThrownBy(() -> Lab.open(wish))
                    .isInstanceOf(IOException.class)
                    .hasMessage("port " + port + " for the hemisson is taken; 0 takes a free one");
        }
    }

    @Test
    void twoLabsOnDefaultPortsRunSideBySide() throws IOException {
        try (Lab first = Lab.open(LabOptions.standard());
                Lab second = Lab.open(LabOptions.standard())) {
            assertThat(first.addresses().values())
                    .doesNotContainAnyElementsOf(second.addresses().values());
        }
    }

    @Test
    void aRoomWithoutSpaceIsRefused() throws IOException {
        Room cell = Room.parse(
                new StringReader("2D-Map\nLINES\n-90 -90 90 -90\n90 -90 90 90\n90 90 -90 90\n-90 90 -90 -90\n"),
                "cell");
        LabOptions options = LabOptions.exactOnFreePorts().withRoom(cell);
        assertThatThrownBy(() -> Lab.open(options)).hasMessageStartingWith("the room cannot hold the robots: ");
    }

    @Test
    void aPortNumberThatIsNoneIsRefused() {
        assertThatThrownBy(() -> new LabPorts(65536, 0, 0, 0, 0)).hasMessage("a port must be 0 to 65535, not 65536");
    }

    @Test
    void everyBytePassesTheCounters() throws IOException {
        try (Client client = new Client(lab.addresses().get("hemisson"))) {
            client.send("B\r");
            assertThat(client.read(17)).isEqualTo("b,HemiOS_v_1.50\r\n");
            LineCount wanted = new LineCount(lab.addresses().get("hemisson"), client.key(), 2, 17, true, false);
            while (!lab.lines().contains(wanted)) {
                Thread.onSpinWait();
            }
        }
    }

    private Pose poseAfterDriving(long seed) throws IOException {
        LabOptions noisy = LabOptions.exactOnFreePorts().withNoise(seed);
        try (Lab noisyLab = Lab.open(noisy);
                Client client = new Client(noisyLab.addresses().get("hemisson"))) {
            client.send("D,9,7\r");
            client.read(3);
            for (int i = 0; i < 500; i++) {
                noisyLab.step();
            }
            return noisyLab.truePoses().get("hemisson");
        }
    }

    private void steps(int count) {
        for (int i = 0; i < count; i++) {
            lab.step();
        }
    }
}
