package majic.mavlink;

import static majic.mavlink.VehicleFrames.fields;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.Parameter;
import majic.bot.RangeScan;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** The range finders of a vehicle. */
class RangeFindersTest {
    @AutoClose
    private final DrivenRover robot = new DrivenRover().ready();

    private final MajicMavlink bot = robot.bot();

    /** A range finder: from 20 cm to 8 m. */
    private void report(int id, int orientation, int cm) {
        robot.rover.send(
                132,
                fields(39)
                        .putInt(0)
                        .putShort((short) 20)
                        .putShort((short) 800)
                        .putShort((short) cm)
                        .put((byte) 0)
                        .put((byte) id)
                        .put((byte) orientation));
        robot.pass(0.05);
    }

    /** A ring with one thing in it: clockwise in steps of 5 degrees, from ahead. */
    private void reportRing(int index, int cm) {
        ByteBuffer ring = fields(167).putLong(0);
        for (int beam = 0; beam < 72; beam++) {
            ring.putShort((short) (beam == index ? cm : 1001));
        }
        ring.putShort((short) 20)
                .putShort((short) 1000)
                .put((byte) 0)
                .put((byte) 5)
                .put(166, (byte) 12);
        robot.rover.send(330, ring);
        robot.pass(0.05);
    }

    @Test
    void aVehicleWithoutThemHasNoDistances() {
        assertThat(bot.parameters()).extracting(Parameter::name).doesNotContain("distanceFront");
        assertThat(bot.rangeSensors()).isEmpty();
    }

    @Test
    void aDistanceIsMeasuredFromTheHull() {
        report(1, 0, 150);

        assertThat(bot.get("distanceFront")).isEqualTo(Value.of(1500 - 350, Unit.MM));
        assertThat(bot.get("distanceLeft").toString()).isEqualTo("unknown (no sensor looks there)");
    }

    @Test
    void nothingInReachIsClear() {
        report(1, 0, 800);

        assertThat(bot.get("distanceFront")).isEqualTo(Value.CLEAR);
    }

    @Test
    void anOldDistanceIsUnknown() {
        report(1, 0, 150);
        robot.pass(1);

        assertThat(bot.get("distanceFront").toString()).isEqualTo("unknown (nothing measured there)");
    }

    @Test
    void aRingIsClockwise() {
        reportRing(18, 200);

        assertThat(bot.get("distanceRight")).isEqualTo(Value.of(2000 - 350, Unit.MM));
        assertThat(bot.get("distanceLeft")).isEqualTo(Value.CLEAR);
    }

    @Test
    void whatIsMeasuredIsPublishedForMaps() {
        List<RangeScan> scans = new CopyOnWriteArrayList<>();
        bot.addScanListener(scans::add);

        reportRing(18, 200);
        report(3, 2, 150);
        robot.clock().until(() -> scans.size() == 2);

        assertThat(scans.get(0).sensor().beams().get(18).mount().headingDeg()).isEqualTo(-90);
        assertThat(scans.get(0).rangeMm(18)).isEqualTo(2000);
        assertThat(scans.get(0).rangeMm(0)).isInfinite();
        assertThat(scans.get(1).sensor().name()).isEqualTo("range3");
        assertThat(scans.get(1).rangeMm(0)).isEqualTo(1500);
    }
}
