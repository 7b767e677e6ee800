package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majic.inlab.acts.ActLabs;
import majic.lab.LabAccess.Wall;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the Pioneer's driver with the lab's Pioneer, on the lab's stepped clock. */
class PioneerInLabTest {
    private static final double FRONT_MM = 210;
    private static final double REAR_MM = 301;
    private static final double HALF_WIDTH_MM = 200;
    /** A bound above the distance between two points of the sampled outline, mm. */
    private static final double SAFE_MM = 50;

    private static final double TEN_MINUTES_S = 600;

    @AutoClose
    private LabRig rig;

    private MajicBot bot;
    private double leastClearMm = Double.MAX_VALUE;

    @ParameterizedTest
    @ValueSource(doubles = {1000, -1000, 300, -50, 5})
    void movesByItsOdometryAndTheRoom(double mm) {
        connect(LabRig.exact());

        double covered = amount(bot.move(mm));

        assertThat(covered).isCloseTo(mm, within(10.0));
        assertThat(rig.truePose("pioneer").xMm()).isCloseTo(covered, within(2.0));
    }

    @ParameterizedTest
    @ValueSource(doubles = {90, -90, 540, -720, 2})
    void turnsByItsOdometryAndTheRoom(double degrees) {
        connect(LabRig.exact());

        double covered = amount(bot.turn(degrees));

        assertThat(covered).isCloseTo(degrees, within(1.0));
        assertThat(Pose.normalised(rig.truePose("pioneer").headingDeg() - covered))
                .isCloseTo(0, within(0.5));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void arrivesByItsOdometryInSpiteOfNoise(long seed) {
        connect(LabRig.noisy(seed));

        assertThat(amount(bot.move(700))).isCloseTo(700, within(10.0));
        assertThat(amount(bot.turn(-120))).isCloseTo(-120, within(1.0));
    }

    static Stream<Named<Supplier<LabRig>>> labs() {
        return ActLabs.labs(1);
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void wandersForTenMinutesAndTouchesNothing(Supplier<LabRig> lab) {
        connect(lab.get());
        bot.addListener(new BotListener() {
            @Override
            public void stateChanged(MajicBot from, BotState state) {
                leastClearMm = Math.min(leastClearMm, clearMm(rig.truePose("pioneer")));
            }
        });
        Guard near = () -> bot.get("distanceFront").number() < bot.get("near").number();
        double start = rig.lab().time().nanos() / 1e9;

        while (rig.lab().time().nanos() / 1e9 < start + TEN_MINUTES_S) {
            bot.move(5000, near);
            bot.turn(73);
        }

        assertThat(leastClearMm).isGreaterThan(SAFE_MM);
    }

    private void connect(LabRig with) {
        rig = with;
        bot = rig.add("pioneer");
    }

    private static double amount(MotionReport report) {
        return report.amount() == null ? Double.NaN : report.amount().number();
    }

    /** Returns the distance from the hull's outline to the nearest wall. */
    private double clearMm(Pose at) {
        double least = Double.MAX_VALUE;
        for (double share = 0; share <= 1; share += 0.05) {
            double x = FRONT_MM - share * (FRONT_MM + REAR_MM);
            double y = HALF_WIDTH_MM - share * 2 * HALF_WIDTH_MM;
            least = Math.min(least, Math.min(wallMm(at, x, HALF_WIDTH_MM), wallMm(at, x, -HALF_WIDTH_MM)));
            least = Math.min(least, Math.min(wallMm(at, FRONT_MM, y), wallMm(at, -REAR_MM, y)));
        }
        return least;
    }

    private double wallMm(Pose at, double ahead, double left) {
        double heading = Math.toRadians(at.headingDeg());
        double x = at.xMm() + ahead * Math.cos(heading) - left * Math.sin(heading);
        double y = at.yMm() + ahead * Math.sin(heading) + left * Math.cos(heading);
        return rig.lab().walls().stream()
                .mapToDouble(wall -> distance(wall, x, y))
                .min()
                .orElseThrow();
    }

    private static double distance(Wall wall, double x, double y) {
        double wx = wall.x2() - wall.x1();
        double wy = wall.y2() - wall.y1();
        double share = ((x - wall.x1()) * wx + (y - wall.y1()) * wy) / (wx * wx + wy * wy);
        double on = Math.max(0, Math.min(1, share));
        return Math.hypot(wall.x1() + on * wx - x, wall.y1() + on * wy - y);
    }
}
