package majic.pioneer.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Objects;
import java.util.Optional;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.LaserChunk;
import majic.pioneer.arcos.SipBytes;
import org.junit.jupiter.api.Test;

class LaserScansTest {
    private static final Model MODEL = Models.of("p3dx-sh");
    private static final long SECOND = 1_000_000_000;

    /** Of five readings. */
    private static final String FIRST_THREE = "00 00 00 00 00 00  05 00 00 00 03  E8 03 D0 07 B8 0B";

    private static final String LAST_TWO = "00 00 00 00 00 00  05 00 03 00 02  A0 0F 00 7D";

    private final LaserScans scans = new LaserScans(MODEL);
    private final StateTracker tracker = new StateTracker(MODEL, Pose.START);
    private PioneerState state = tracker.track(new SipBytes().sip(), SECOND);

    private Optional<RangeScan> add(String data) {
        byte[] packet = Bytes.wire(0x60, Bytes.of(data));
        return scans.add(Objects.requireNonNull(LaserChunk.decode(Bytes.packet(Bytes.hex(packet)))), state);
    }

    @Test
    void theLastPacketCompletesAScanOverTheHalfCircleAhead() {
        assertThat(add(FIRST_THREE)).isEmpty();
        RangeScan scan = add(LAST_TWO).orElseThrow();

        assertThat(scan.sensor().name()).isEqualTo("laser");
        assertThat(scan.sensor().beams())
                .extracting(beam -> beam.mount().headingDeg())
                .containsExactly(-90.0, -45.0, 0.0, 45.0, 90.0);
        assertThat(scan.sensor().beams()).allMatch(beam -> beam.mount().xMm() == 21);
        assertThat(scan.rangeMm(0)).isEqualTo(1000);
        assertThat(scan.rangeMm(3)).isEqualTo(4000);
        assertThat(scan.rangeMm(4)).isEqualTo(Float.POSITIVE_INFINITY);
    }

    @Test
    void aScanHasTimeAndOdometryOfItsFirstPacket() {
        add(FIRST_THREE);
        state = tracker.track(new SipBytes().pose(50, 0, 0).sip(), 2 * SECOND);
        RangeScan scan = add(LAST_TWO).orElseThrow();

        assertThat(scan.timeS()).isCloseTo(1, within(1e-6));
        assertThat(scan.odometry()).isEqualTo(Pose.START);
    }

    @Test
    void aScanWithALostPacketIsDroppedAndTheNextOneIsWhole() {
        add(FIRST_THREE);
        assertThat(add(FIRST_THREE)).isEmpty();
        assertThat(add(LAST_TWO)).isPresent();
        assertThat(add(LAST_TWO)).isEmpty();
        add(FIRST_THREE);
        assertThat(add("00 00 00 00 00 00  05 00 04 00 01  A0 0F")).isEmpty();
        assertThat(add(LAST_TWO)).isEmpty();
    }

    @Test
    void allScansOfASessionHaveTheSameSensor() {
        add(FIRST_THREE);
        RangeScan one = add(LAST_TWO).orElseThrow();
        add(FIRST_THREE);

        assertThat(add(LAST_TWO).orElseThrow().sensor()).isSameAs(one.sensor());
    }

    @Test
    void theLaserOfALongDeckIsFartherAhead() {
        LaserScans longDeck = new LaserScans(Models.of("p3at-sh"));
        byte[] packet = Bytes.wire(0x60, Bytes.of("00 00 00 00 00 00  01 00 00 00 01  E8 03"));
        RangeScan scan = longDeck.add(Objects.requireNonNull(LaserChunk.decode(Bytes.packet(Bytes.hex(packet)))), state)
                .orElseThrow();

        assertThat(scan.sensor().beams().get(0).mount().xMm()).isEqualTo(125);
    }
}
