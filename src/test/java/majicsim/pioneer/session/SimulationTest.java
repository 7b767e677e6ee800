package majicsim.pioneer.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import majicsim.pioneer.LaserView;
import majicsim.pioneer.Rig;
import majicsim.pioneer.packet.Hex;
import majicsim.pioneer.packet.PacketWriter;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;

/** What only a simulator can do (ARCOS sheet 6.2, 11.7, 11.8). */
class SimulationTest {
    private static final int ADSEL = 35;
    private static final int SIM_RESET = 225;
    private static final int LRF_ENABLE = 230;
    private static final int LRF_START = 231;
    private static final int LRF_END = 232;
    private static final int LRF_STEP = 233;
    private static final int SIM_CTRL = 236;
    private static final int SIM_STAT = 237;
    private static final int SIM_EXIT = 239;
    private static final int LASER_AHEAD_MM = 21;
    private static final String WITH_LASER = "p3dx-sh+laser";

    @Test
    void theLaserIsSilentUntilItIsSwitchedOnAndAgainAfterwards() {
        Rig rig = Rig.open(WITH_LASER);
        assertThat(scan(rig)).isEmpty();
        assertThat(scan(rig.command(LRF_ENABLE, 1))).isNotEmpty();
        assertThat(scan(rig.command(LRF_ENABLE, 0))).isEmpty();
    }

    @Test
    void aRobotWithoutALaserIgnoresItsCommands() {
        Rig rig = Rig.open();
        assertThat(scan(rig.command(LRF_ENABLE, 1))).isEmpty();
        assertThat(scan(rig.command(36, -90).command(37, 90).command(38, 100).command(ADSEL, 2)))
                .isEmpty();
        assertThat(rig.nextSip().analogPort()).isEqualTo(2);
    }

    @Test
    void thePacketsAreByteForByteThoseOfTheSheet() {
        Rig rig = Rig.open(WITH_LASER).command(LRF_START, -1).command(LRF_END, 1);
        assertThat(laserPacket(rig.command(LRF_ENABLE, 1)))
                .isEqualTo(Hex.bytes("FA FB 14 60 00 00 00 00 00 00 03 00 00 00 03 74 13 73 13 74 13 BB 3F"));
        assertThat(laserPacket(rig.command(LRF_ENABLE, 2)))
                .isEqualTo(Hex.bytes(
                        "FA FB 19 61 03 00 00 00 03 74 13 00 00 00 73 13 00 00 00 74 13 00 00 00" + " 00 00 5C 9F"));
    }

    private static byte[] laserPacket(Rig rig) {
        rig.line.take();
        return rig.step(0.1).line.take().stream()
                .filter(LaserView::isLaser)
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aScanOfHalfACircleComesBehindTheSipInPacketsOfAtMost32Readings() {
        List<LaserView> scan = scan(Rig.open(WITH_LASER).command(LRF_ENABLE, 1));
        assertThat(scan).extracting(LaserView::first).containsExactly(0, 32, 64, 96, 128, 160);
        assertThat(scan).allMatch(packet -> packet.total() == 181 && packet.type() == 0x60);
        assertThat(ranges(scan)).hasSize(181);
    }

    @Test
    void readingsGoFromTheRightToTheLeftAndMeasureTheRoom() {
        List<Integer> ranges = ranges(scan(Rig.open(WITH_LASER).command(LRF_ENABLE, 2)));
        assertThat(ranges.get(0)).isEqualTo(4000);
        assertThat(ranges.get(90)).isEqualTo(5000 - LASER_AHEAD_MM);
        assertThat(ranges.get(180)).isEqualTo(4000);
        assertThat(ranges.get(135)).isEqualTo((int) Math.round(4000 * Math.sqrt(2)));
    }

    @Test
    void fieldOfViewAndStepAreTheClients() {
        Rig rig = Rig.open(WITH_LASER)
                .command(LRF_START, -10)
                .command(LRF_END, 20)
                .command(LRF_STEP, 50);
        List<Integer> ranges = ranges(scan(rig.command(LRF_ENABLE, 2)));
        assertThat(ranges).hasSize(61);
        assertThat(ranges.get(20)).isEqualTo(5000 - LASER_AHEAD_MM);
    }

    @Test
    void theShortPacketCarriesTheOdometry() {
        Rig rig = Rig.ready(WITH_LASER).command(8, 300).pulse(4).command(12, 90).pulse(4);
        assertThat(scan(rig.command(LRF_ENABLE, 1)).get(0).pose()).containsExactly(300, 0, 90);
    }

    @Test
    void theLongPacketReportsOnceThatTheRobotWasLifted() {
        Rig rig = Rig.open(WITH_LASER).command(LRF_ENABLE, 2);
        assertThat(scan(rig)).allMatch(packet -> packet.flags() == 0);
        rig.packet(224, "3B 64 00 00 00 00 00 00 00 00 00 00 00");
        assertThat(scan(rig)).extracting(LaserView::flags).startsWith(1).containsOnlyOnce(1);
        assertThat(scan(rig)).allMatch(packet -> packet.flags() == 0);
    }

    @Test
    void aNoisyLaserIsOffByMillimetres() {
        Rig rig = new Rig(new Pose(0, 0, 0), Noise.seeded(3), WITH_LASER).shakeHands();
        assertThat(ranges(scan(rig.command(LRF_ENABLE, 2))).get(90)).isCloseTo(5000 - LASER_AHEAD_MM, within(15));
    }

    @Test
    void theVendorsClientSwitchesItOnByTheOldNumbers() {
        Rig rig = Rig.open(WITH_LASER)
                .command(36, -90)
                .command(37, 90)
                .command(38, 100)
                .command(ADSEL, 2);
        assertThat(scan(rig)).hasSize(6).allMatch(packet -> packet.type() == 0x61);
        assertThat(rig.nextSip().analogPort()).isZero();
        assertThat(scan(rig.command(ADSEL, 0))).isEmpty();
    }

    @Test
    void theOldNumbersAreTheRobotsInAnyOtherConnection() {
        Rig rig = Rig.open(WITH_LASER)
                .command(36, 5)
                .command(37, 2)
                .command(38, 100)
                .command(ADSEL, 2);
        assertThat(scan(rig)).isEmpty();
        assertThat(rig.nextSip().analogPort()).isEqualTo(2);
    }

    @Test
    void theNextClientFindsTheLaserOff() {
        Rig rig = Rig.open(WITH_LASER).command(LRF_ENABLE, 1);
        rig.reconnect();
        assertThat(scan(rig.shakeHands())).isEmpty();
    }

    @Test
    void theTruePoseIsSentAtOnceOrWithEverySip() {
        Rig rig = Rig.open();
        rig.line.take();
        rig.command(SIM_STAT, 1);
        assertThat(rig.line.take())
                .singleElement()
                .satisfies(packet -> assertThat(packet[3]).isEqualTo((byte) 0x62));
        rig.command(SIM_STAT, 2).step(0.2);
        assertThat(rig.line.take()).extracting(packet -> (int) packet[3]).containsExactly(0x62, 0x32, 0x62, 0x32);
        assertThat(rig.command(SIM_STAT, 0).step(0.1).line.take()).hasSize(1);
    }

    @Test
    void resetPutsItBackToItsStart() {
        Rig rig = Rig.ready().command(8, 500).pulse(4).command(SIM_RESET, 0);
        assertThat(rig.pose()).isEqualTo(new Pose(0, 0, 0));
        assertThat(rig.nextSip().x()).isZero();
    }

    @Test
    void theSimulatorReportsItsNameAndItsDevices() {
        Rig rig = Rig.open(WITH_LASER);
        rig.line.take();
        byte[] info = rig.command(SIM_CTRL, 6).line.take().get(0);
        assertThat(info[3]).isEqualTo((byte) 0x63);
        String text = new String(info, 4, info.length - 6, StandardCharsets.ISO_8859_1);
        assertThat(text).startsWith("majicsim\0S.0\0\0\0\0\0\2\0\0\0sonar\0sonar\0\0\1\0\0\0laser\0laser\0\0\0\0\0\0");
    }

    @Test
    void aRequestedMapIsAnsweredAsNotChanged() {
        Rig rig = Rig.open();
        rig.line.take();
        rig.packet(SIM_CTRL, "3B 01 00 05 00 61 2E 6D 61 70");
        byte[] wanted = new PacketWriter(0x66).uint8(0).uint8(0).text("a.map").toBytes();
        assertThat(rig.line.take()).containsExactly(wanted);
    }

    @Test
    void ordersTooShortOrUnknownAreIgnored() {
        Rig rig = Rig.open();
        rig.line.take();
        rig.packet(SIM_CTRL, "")
                .packet(SIM_CTRL, "3B 01")
                .packet(SIM_CTRL, "3B 01 00 FF FF 61")
                .command(SIM_CTRL, 99);
        assertThat(rig.line.take()).extracting(packet -> (int) packet[3]).containsOnly(0x66);
        assertThat(rig.nextSip().flags()).isEqualTo(0x1E);
    }

    @Test
    void exitIsNotForOneClientToOrder() {
        Rig rig = Rig.open().command(SIM_EXIT, 0);
        assertThat(rig.line.isOpen()).isTrue();
        assertThat(rig.nextSip().flags()).isEqualTo(0x1E);
    }

    private static List<LaserView> scan(Rig rig) {
        rig.line.take();
        return rig.step(0.1).line.take().stream()
                .filter(LaserView::isLaser)
                .map(LaserView::new)
                .toList();
    }

    private static List<Integer> ranges(List<LaserView> scan) {
        return scan.stream().flatMap(packet -> packet.ranges().stream()).toList();
    }
}
