package majic.bot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class RangeScanTest {
    private static final RangeSensor SENSOR = RangeSensor.laser(new Pose(100, 0, 0), 3, -90, 90, 5000, 10);

    @Test
    void aDistanceFromTheReachOnIsNoEcho() {
        RangeScan scan = new RangeScan(SENSOR, 0, Pose.START, 4999, 5000, Float.NaN);

        assertThat(scan.rangeMm(0)).isEqualTo(4999);
        assertThat(scan.rangeMm(1)).isInfinite();
        assertThat(scan.rangeMm(2)).isNaN();
    }

    @Test
    void aDistanceBelowTheLeastIsNothingMeasured() {
        RangeSensor sonar = new RangeSensor("sonar", java.util.List.of(new Beam(Pose.START, 30, 150, 3000, 20)));

        assertThat(new RangeScan(sonar, 0, Pose.START, 149).rangeMm(0)).isNaN();
    }

    @Test
    void laterChangesOfTheArrayDoNotChangeAScan() {
        float[] ranges = {1, 2, 3};
        RangeScan scan = new RangeScan(SENSOR, 0, Pose.START, ranges);
        ranges[0] = 9;

        assertThat(scan.rangeMm(0)).isEqualTo(1);
    }

    @Test
    void aScanHasARangeForEachBeam() {
        assertThatThrownBy(() -> new RangeScan(SENSOR, 0, Pose.START, 1, 2)).hasMessageContaining("3 ranges, not 2");
    }

    @Test
    void aRelativePoseAddedToItsOriginIsThePoseAgain() {
        Pose from = new Pose(1000, -500, 120);
        Pose to = new Pose(-300, 200, -170);

        Pose again = from.plus(to.seenFrom(from));

        assertThat(again.distanceMm(to)).isCloseTo(0, within(1e-6));
        assertThat(again.headingDeg()).isCloseTo(-170, within(1e-9));
    }
}
