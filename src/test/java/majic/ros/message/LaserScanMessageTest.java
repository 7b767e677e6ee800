package majic.ros.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class LaserScanMessageTest {
    @Test
    void inARecordedScanRangesOutsideOfTheLimitsAreUnknown() {
        LaserScanMessage scan = LaserScanMessage.from(Recorded.message("/scan"));

        assertThat(scan.frame()).isEqualTo("base_scan");
        assertThat(scan.beams()).isEqualTo(8);
        assertThat(scan.directionDeg(2)).isCloseTo(90, within(1e-4));
        assertThat(scan.stepDeg()).isCloseTo(45, within(1e-4));
        assertThat(IntStream.range(0, 8).mapToDouble(scan::rangeMm))
                .containsExactly(1000.0, 2000.0, Double.NaN, Double.NaN, Double.NaN, Double.NaN, 3500.0, 500.0);
    }

    @Test
    void infinityAndNanAreUnknownAndNotFree() {
        LaserScanMessage scan = LaserScanMessage.from(
                Recorded.json(
                        "{'angle_min':0,'angle_increment':0.1,'range_min':0.1,'range_max':5,'ranges':[Infinity,-Infinity,NaN,9,'2',0.05]}"));

        assertThat(IntStream.range(0, 6).mapToDouble(scan::rangeMm)).containsOnly(Double.NaN);
        assertThat(IntStream.range(0, 6).mapToDouble(scan::measuredMm))
                .containsExactly(
                        Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NaN, 9000.0, Double.NaN, 50.0);
    }

    @Test
    void aScanWithoutBeamsIsRead() {
        assertThat(LaserScanMessage.from(Recorded.json("{'angle_min':0,'angle_increment':0,'ranges':[]}"))
                        .beams())
                .isZero();
    }

    @Test
    void aScanWithoutAnglesOrRangesIsRefused() {
        assertThatThrownBy(() -> LaserScanMessage.from(Recorded.json("{'angle_increment':0.1,'ranges':[1]}")))
                .hasMessage("angle_min has to be a finite number, not absent");
        assertThatThrownBy(() -> LaserScanMessage.from(Recorded.json("{'angle_min':0,'ranges':null}")))
                .hasMessage("ranges has to be a list, not null");
    }
}
