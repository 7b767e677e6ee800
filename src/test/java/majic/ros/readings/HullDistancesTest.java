package majic.ros.readings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import majic.bot.Unit;
import majic.bot.Value;
import majic.ros.message.FrameTransform;
import majic.ros.message.LaserScanMessage;
import majic.ros.message.Orientation;
import majic.ros.message.RangeMessage;
import majic.ros.message.Vector;
import majic.ros.readings.HullDistances.Beam;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class HullDistancesTest {
    private static final HullDistances HULL = new HullDistances(100, NoEcho.UNKNOWN);
    private static final FrameTransform CENTRE = FrameTransform.NONE;
    private static final FrameTransform BEHIND_50_MM = new FrameTransform(new Vector(-50, 0, 0), Orientation.NONE);
    private static final FrameTransform BEHIND_BACKWARDS =
            new FrameTransform(new Vector(-50, 0, 0), new Orientation(0, 0, 1, 0));

    @Test
    void inFreeSpaceAllSidesAreClear() {
        ScanPoints far = scan(CENTRE, angle -> 3.0);

        for (HullSide side : HullSide.values()) {
            assertThat(HULL.distance(side, Optional.of(far), List.of())).isEqualTo(mm(2900));
        }
    }

    @ParameterizedTest
    @CsvSource({"FRONT, 0", "LEFT, 90", "BACK, 180", "RIGHT, 270"})
    void anEchoCountsFromTheHullOnItsSideOnly(HullSide side, int direction) {
        ScanPoints scan = scan(CENTRE, angle -> angle == direction ? 0.5 : 3.0);

        assertThat(HULL.distance(side, Optional.of(scan), List.of())).isEqualTo(mm(400));
        for (HullSide other : HullSide.values()) {
            if (other != side) {
                assertThat(HULL.distance(other, Optional.of(scan), List.of())).isEqualTo(mm(2900));
            }
        }
    }

    @Test
    void theMountingOfTheScannerIsTakenIntoAccount() {
        ScanPoints scan = scan(BEHIND_BACKWARDS, angle -> angle == 180 ? 0.5 : 3.0);

        assertThat(HULL.distance(HullSide.FRONT, Optional.of(scan), List.of())).isEqualTo(mm(350));
    }

    @Test
    void whatIsBesideTheWayIsNotAhead() {
        ScanPoints scan = scan(CENTRE, angle -> angle == 30 ? 0.3 : Double.NaN);

        assertThat(HULL.distance(HullSide.FRONT, Optional.of(scan), List.of())).isInstanceOf(Value.Unknown.class);
        assertThat(new HullDistances(160, NoEcho.UNKNOWN).distance(HullSide.FRONT, Optional.of(scan), List.of()))
                .isEqualTo(mm(Math.round(300 * Math.cos(Math.PI / 6) - Math.sqrt(160 * 160 - 150 * 150))));
    }

    @Test
    void theRobotItselfIsNoObstacle() {
        ScanPoints scan = scan(CENTRE, angle -> angle == 2 ? 0.07 : 2.0);

        assertThat(HULL.distance(HullSide.FRONT, Optional.of(scan), List.of())).isEqualTo(mm(1900));
    }

    @ParameterizedTest
    @EnumSource(HullSide.class)
    void whereNoBeamHasAnEchoNothingIsKnown(HullSide side) {
        ScanPoints dark = scan(CENTRE, angle -> Double.NaN);

        assertThat(HULL.distance(side, Optional.of(dark), List.of()))
                .isEqualTo(Value.unknown("no echo there: free, or too near, black or shiny"));
        assertThat(new HullDistances(100, NoEcho.CLEAR).distance(side, Optional.of(dark), List.of()))
                .isEqualTo(Value.CLEAR);
    }

    @ParameterizedTest
    @CsvSource({"3, clear", "9, clear", "12, unknown", "40, unknown"})
    void aNarrowGapIsUsualAndAWideOneHidesSomething(int gapDeg, String expected) {
        // All echoes are beside the way ahead, as those of the walls of a corridor.
        ScanPoints corridor = scan(
                CENTRE,
                angle -> Math.abs(Math.IEEEremainder(angle, 360)) <= gapDeg / 2.0
                        ? Double.NaN
                        : 0.2 / Math.abs(Math.sin(Math.toRadians(angle))));

        Value front = HULL.distance(HullSide.FRONT, Optional.of(corridor), List.of());

        assertThat(front.toString()).startsWith(expected);
    }

    @ParameterizedTest
    @CsvSource({"1000, clear", "100, clear", "60, unknown"})
    void noEchoIsClearIfWhatIsTooNearForTheScannerWouldTouchTheHull(double radiusMm, String expected) {
        ScanPoints openAhead =
                scan(BEHIND_50_MM, angle -> Math.abs(Math.IEEEremainder(angle, 360)) < 45 ? Double.NaN : 3.0);

        Value front = new HullDistances(radiusMm, NoEcho.AUTO)
                .distance(HullSide.FRONT, Optional.of(ScanPoints.of(scanFrom170Mm(), BEHIND_50_MM)), List.of());

        assertThat(front.toString()).startsWith(expected);
        assertThat(new HullDistances(radiusMm, NoEcho.AUTO).distance(HullSide.BACK, Optional.of(openAhead), List.of()))
                .isInstanceOf(Value.Number.class);
    }

    @Test
    void aScanWithoutAnyEchoIsNeverClearByItself() {
        ScanPoints dark = scan(CENTRE, angle -> Double.NaN);

        assertThat(new HullDistances(100, NoEcho.AUTO).distance(HullSide.FRONT, Optional.of(dark), List.of()))
                .isInstanceOf(Value.Unknown.class);
    }

    @Test
    void aScannerThatOnlyLooksAheadKnowsNothingBehind() {
        ScanPoints half = points(CENTRE, -60, 120, angle -> 2.0);

        assertThat(HULL.distance(HullSide.BACK, Optional.of(half), List.of()))
                .isEqualTo(Value.unknown("no sensor looks there"));
        assertThat(HULL.distance(HullSide.FRONT, Optional.of(half), List.of())).isEqualTo(mm(1900));
    }

    @Test
    void singleBeamsMeasureTheSidesToWhichTheyLook() {
        Beam behind = new Beam(new RangeMessage("sonar", 300, 20, 4000, 30), BEHIND_BACKWARDS);
        Beam silent = new Beam(new RangeMessage("tof", Double.NaN, 20, 4000, 30), CENTRE);

        assertThat(HULL.distance(HullSide.BACK, Optional.empty(), List.of(behind, silent)))
                .isEqualTo(mm(250));
        assertThat(HULL.distance(HullSide.FRONT, Optional.empty(), List.of(behind, silent)))
                .isInstanceOf(Value.Unknown.class);
        assertThat(HULL.distance(HullSide.LEFT, Optional.empty(), List.of(behind, silent)))
                .isEqualTo(Value.unknown("no sensor looks there"));
    }

    @Test
    void theSummaryHasTheNearestEchoOfEachSector() {
        ScanPoints scan =
                scan(CENTRE, angle -> angle == 345 ? 0.4 : angle == 90 ? 0.6 : angle > 200 ? Double.NaN : 2.0);
        ScanSummary summary = ScanSummary.of(scan);

        assertThat(summary.values().toString())
                .startsWith("400 mm, 2000 mm, 2000 mm, 600 mm, 2000 mm")
                .endsWith("unknown (no echo), unknown (no echo), unknown (no echo)");
        assertThat(summary.nearestMm(scan)).isEqualTo(mm(400));
        assertThat(summary.bearing(scan).number()).isCloseTo(-15, within(1e-6));
    }

    /** Echoes everywhere but ahead, of a scanner that measures from 170 mm on. */
    private static LaserScanMessage scanFrom170Mm() {
        String ranges = IntStream.range(0, 36)
                .mapToObj(beam -> beam < 6 || beam > 30 ? "null" : "2.9")
                .collect(Collectors.joining(","));
        return LaserScanMessage.from(
                FakeRosClient.json("{'angle_min':0,'angle_increment':%s,'range_min':0.17,'range_max':3.5,'ranges':[%s]}"
                        .formatted(Math.toRadians(10), ranges)));
    }

    private static Value mm(double amount) {
        return Value.of(amount, Unit.MM);
    }

    /** A scan of 360 beams, one for each degree. */
    private static ScanPoints scan(FrameTransform scanner, IntToDoubleFunction metres) {
        return points(scanner, 0, 360, metres);
    }

    private static ScanPoints points(FrameTransform scanner, int firstDeg, int beams, IntToDoubleFunction metres) {
        String ranges = IntStream.range(firstDeg, firstDeg + beams)
                .mapToObj(
                        angle -> Double.isNaN(metres.applyAsDouble(angle)) ? "null" : "" + metres.applyAsDouble(angle))
                .collect(Collectors.joining(","));
        return ScanPoints.of(
                LaserScanMessage.from(FakeRosClient.json(
                        "{'angle_min':%s,'angle_increment':%s,'range_min':0.05,'range_max':3.5,'ranges':[%s]}"
                                .formatted(Math.toRadians(firstDeg), Math.toRadians(1), ranges))),
                scanner);
    }
}
