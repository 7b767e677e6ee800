package majicsim.pioneer.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import majicsim.pioneer.model.Generation;
import majicsim.pioneer.model.PioneerModel;
import majicsim.pioneer.motion.Limits;
import majicsim.pioneer.motion.MotionLimits;
import majicsim.pioneer.packet.Hex;
import majicsim.pioneer.ranging.SonarReading;
import majicsim.pioneer.session.Handshake;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;

/** Packets of the ARCOS sheet's appendix A, encoded again from their contents. */
class CapturedPacketsTest {
    private static final PioneerModel P3DX = PioneerModel.of("p3dx");
    private static final SipTail IDLE =
            new SipTail(Generation.AROS, 0, 0, 0, 0xFF, 0xFF, 0, 0, SipTail.NO_TEMPERATURE, 0, 0);

    @Test
    void replyToSync2() {
        Handshake handshake = new Handshake("AMRISim", P3DX);
        handshake.answer(0);
        handshake.answer(1);
        assertThat(handshake.answer(2))
                .isEqualTo(
                        Hex.bytes("FA FB 18 02 41 4D 52 49 53 69 6D 00 50 69 6F 6E 65 65 72 00 70 33 64 78 00 EB BD"));
    }

    @Test
    void config() {
        Limits top = new Limits(9999, 9999, 9999);
        MotionLimits limits = new MotionLimits(new Limits(3000, 300, 300), new Limits(150, 100, 100));
        ConfigReport report = new ConfigReport("AMRISim", P3DX, new MotionLimits(top, top), limits, setting -> 0, 0, 0);
        assertThat(report.toBytes()).isEqualTo(Hex.bytes("""
                FA FB 79 20 50 69 6F 6E 65 65 72 00 70 33 64 78 00 53 49 4D 00 00
                0F 27 0F 27 0F 27 0F 27 90 01 41 4D 52 49 53 69 6D 00 64 00 00
                00 00 01 00 01 00 00 00 00 D0 07 00 00 00 00 00 00 00 00 00
                96 00 B8 0B 64 00 64 00 00 00 00 00 00 00 2C 01 2C 01 00 00 00 00 00 00
                00 00 00 00 02 00 00 00 00 00 00 00 00 00 53 2E 30 00 00 00 00 00 00
                0F 27 0F 27 00 00 00 00 00 00 00 00 93 5F
                """));
    }

    @Test
    void sipAtRest() {
        Sip.Motion rest = new Sip.Motion(0, 0, 0, 0, 0, 0, 0);
        int[] ranges = {3864, 5000, 4447, 5000, 5000, 5000, 5000, 3844, 3844, 2765, 2013, 1751, 1752, 2013, 2764, 3864};
        Sip sip = new Sip(rest, new Sip.Status(130, 0, 0, 0x1F, 0), sonar(ranges), IDLE);
        assertThat(sip.toBytes()).isEqualTo(Hex.bytes("""
                FA FB 56 32 00 00 00 00 00 00 00 00 00 00 82 00 00 00 00 1F 00 00 10
                00 18 0F 01 88 13 02 5F 11 03 88 13 04 88 13 05 88 13 06 88 13 07 04 0F
                08 04 0F 09 CD 0A 0A DD 07 0B D7 06 0C D8 06 0D DD 07 0E CC 0A 0F 18 0F
                00 00 00 FF FF 82 00 00 00 00 00 00 00 00 81 00 B0 CD
                """));
    }

    @Test
    void sipDrivingAheadAndTurningRight() {
        Sip.Motion motion = new Sip.Motion(519, -107, -238, 296, 203, 0, -150);
        int[] ranges = {4216, 4135, 5000, 5000, 5000, 4929, 4007, 4032, 4117, 2299, 2011, 2018, 2324, 3205, 4104, 4131};
        byte[] packet = new Sip(motion, new Sip.Status(130, 0, 0, 0x1F, 0), sonar(ranges), IDLE).toBytes();
        byte[] captured = Hex.bytes("""
                FA FB 56 32 07 02 95 FF 12 FF 28 01 CB 00 82 00 00 00 00 1F 00 00 10
                00 78 10 01 27 10 02 88 13 03 88 13 04 88 13 05 41 13 06 A7 0F 07 C0 0F
                08 15 10 09 FB 08 0A DB 07 0B E2 07 0C 14 09 0D 85 0C 0E 08 10 0F 23 10
                00 00 00 FF FF 82 00 00 6A FF 00 00 00 00 81 00 26 9E
                """);
        captured[3] = 0x33; // the vendor's simulator sends 0x32 even when it moves, and the checksum goes with it
        assertThat(Arrays.copyOf(packet, packet.length - 2)).isEqualTo(Arrays.copyOf(captured, captured.length - 2));
    }

    @Test
    void sipStalledAgainstAWall() {
        Sip.Motion motion = new Sip.Motion(606, -140, -250, 0, 0, 0, 0);
        int[] ranges = {3864, 222, 126, 100, 100, 126, 223, 3844, 3844, 5000, 5000, 5000, 5000, 3844, 5000, 3864};
        Sip sip = new Sip(motion, new Sip.Status(130, 1, 1, 0x1F, 0), sonar(ranges), IDLE);
        assertThat(sip.toBytes()).isEqualTo(Hex.bytes("""
                FA FB 56 32 5E 02 74 FF 06 FF 00 00 00 00 82 01 01 00 00 1F 00 00 10
                00 18 0F 01 DE 00 02 7E 00 03 64 00 04 64 00 05 7E 00 06 DF 00 07 04 0F
                08 04 0F 09 88 13 0A 88 13 0B 88 13 0C 88 13 0D 04 0F 0E 88 13 0F 18 0F
                00 00 00 FF FF 82 00 00 00 00 00 00 00 00 81 00 57 F4
                """));
    }

    @Test
    void simStat() {
        SimStat stat = new SimStat(100, new Pose(-4000, -3000, 45), new Pose(0, 0, 0));
        assertThat(stat.toBytes()).isEqualTo(Hex.bytes("""
                FA FB 3B 62 00 00 04 00 00 00 64 00 64 00 64 00 60 F0 FF FF 48 F4 FF FF 00 00 00 00 2D 00 00 00
                00 00 00 00 00 00 00 00 00 00 00 00 FF FF FF FF 00 00 00 00 00 00 00 00 00 00 00 00 48 01
                """));
    }

    private static List<SonarReading> sonar(int... ranges) {
        List<SonarReading> readings = new ArrayList<>();
        for (int disc = 0; disc < ranges.length; disc++) {
            readings.add(new SonarReading(disc, ranges[disc]));
        }
        return readings;
    }
}
