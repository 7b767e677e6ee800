package majic.hemisson.readings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ClearanceTest {
    /** What it takes to stop from cruise, new readings, the line and the wheels' inertia included, mm. */
    private static final double REACTION_MM = 10;

    private static final double NEAR_MM = 40;
    private static final double FAR_MM = 400;

    @Test
    void nothingInRangeIsEmpty() {
        assertThat(Clearance.front(reading(4, 4, 4, 4, 4, 4))).isEmpty();
    }

    @Test
    void distancesFollowFromTheInverseOfTheResponseCurve() {
        assertThat(Clearance.front(reading(20, 4, 4, 4, 4, 4)).orElseThrow()).isCloseTo(27.5, within(0.01));
        assertThat(Clearance.back(reading(4, 4, 4, 4, 4, 34)).orElseThrow()).isCloseTo(25, within(0.01));
        assertThat(Clearance.left(reading(4, 4, 4, 4, 48, 4)).orElseThrow()).isCloseTo(9, within(0.01));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70, 75, 80, 85})
    void aWallAtAnyAngleIsReportedAsNearBeforeContact(int angleDeg) {
        for (int side = -1; side <= 1; side += 2) {
            double normal = Math.toRadians(side * angleDeg);
            double[] wall = wall(FAR_MM * Math.cos(normal), FAR_MM * Math.sin(normal), normal);
            assertThat(gapWhenNear(List.of(wall)))
                    .as("angle %s", side * angleDeg)
                    .isGreaterThan(REACTION_MM);
        }
    }

    @Test
    void aCornerOfABoxIsReportedAsNearBeforeContact() {
        for (int offset = -58; offset <= 58; offset += 2) {
            for (int turned = 0; turned <= 90; turned += 5) {
                List<double[]> box = box(FAR_MM, offset, Math.toRadians(turned - 45));
                assertThat(gapWhenNear(box))
                        .as("corner %s mm aside, turned by %s", offset, turned)
                        .isGreaterThan(REACTION_MM);
            }
        }
    }

    /** Drives ahead until the guard of a wander would stop it; how far the hull then may still go before it touches. */
    private static double gapWhenNear(List<double[]> walls) {
        for (double way = 0; way < 2 * FAR_MM; way++) {
            if (touches(walls, way)) {
                return 0;
            }
            if (Clearance.front(sees(walls, way)).orElse(FAR_MM) < NEAR_MM) {
                return gap(walls, way);
            }
        }
        return FAR_MM;
    }

    private static boolean touches(List<double[]> walls, double x) {
        return walls.stream().anyMatch(wall -> distance(wall, x) < Clearance.HULL_MM);
    }

    private static double gap(List<double[]> walls, double way) {
        for (double ahead = 0; ahead < FAR_MM; ahead++) {
            if (touches(walls, way + ahead)) {
                return ahead;
            }
        }
        return FAR_MM;
    }

    private static Proximity sees(List<double[]> walls, double way) {
        double[][] mounts = {{57.5, 0, 0}, {51, -31, -38}, {51, 31, 38}, {10, -49, -90}, {10, 49, 90}, {-64, 0, 180}};
        List<Integer> values = new ArrayList<>();
        for (double[] mount : mounts) {
            double angle = Math.toRadians(mount[2]);
            double nearest = walls.stream()
                    .mapToDouble(wall -> ray(wall, mount[0] + way, mount[1], Math.cos(angle), Math.sin(angle)))
                    .min()
                    .orElseThrow();
            values.add(response(nearest));
        }
        return reading(values.stream().mapToInt(Integer::intValue).toArray());
    }

    private static int response(double mm) {
        double[] at = {0, 10, 20, 30, 40, 50, 60, 80, 1e9};
        double[] values = {250, 150, 48, 20, 13, 8, 5, 4, 0};
        int step = 1;
        while (mm > at[step]) {
            step++;
        }
        double within = (mm - at[step - 1]) / (at[step] - at[step - 1]);
        return (int) Math.round(values[step - 1] + within * (values[step] - values[step - 1]));
    }

    private static double ray(double[] wall, double x, double y, double dx, double dy) {
        double wx = wall[2] - wall[0];
        double wy = wall[3] - wall[1];
        double cross = dx * wy - dy * wx;
        double along = ((wall[0] - x) * wy - (wall[1] - y) * wx) / cross;
        double onWall = ((wall[0] - x) * dy - (wall[1] - y) * dx) / cross;
        return along >= 0 && onWall >= 0 && onWall <= 1 ? along : 1e8;
    }

    private static double distance(double[] wall, double x) {
        double wx = wall[2] - wall[0];
        double wy = wall[3] - wall[1];
        double share = ((x - wall[0]) * wx - wall[1] * wy) / (wx * wx + wy * wy);
        double at = Math.max(0, Math.min(1, share));
        return Math.hypot(wall[0] + at * wx - x, wall[1] + at * wy);
    }

    private static double[] wall(double x, double y, double normal) {
        double half = 2000;
        double dx = -Math.sin(normal) * half;
        double dy = Math.cos(normal) * half;
        return new double[] {x - dx, y - dy, x + dx, y + dy};
    }

    /** A right-angled corner that points at the robot, its bisector turned by an angle. */
    private static List<double[]> box(double x, double y, double turned) {
        double side = 300;
        List<double[]> sides = new ArrayList<>();
        for (double face : new double[] {turned + Math.PI / 4, turned - Math.PI / 4}) {
            sides.add(new double[] {x, y, x + side * Math.cos(face), y + side * Math.sin(face)});
        }
        return sides;
    }

    private static Proximity reading(int... six) {
        List<Integer> values = new ArrayList<>();
        for (int value : six) {
            values.add(value);
        }
        values.add(60);
        values.add(60);
        return new Proximity(values);
    }
}
