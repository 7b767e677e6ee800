package majic.inlab.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majic.script.MajicParser;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the wander script of the language's manual, unchanged, on all three robots at once. */
@Tag("long")
class WanderInTheLabTest {
    private static final int MINUTES = 10;
    private static final double FAR_MM = 3000;

    static Stream<Named<Supplier<LabRig>>> labs() {
        return ActLabs.labs(2);
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void threeWanderersDriveIntoNothingInTenMinutes(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = lab.get().withAllRobots()) {
            for (int robot = 1; robot <= 3; robot++) {
                wander(rig, robot);
            }
            double[] travelled = watch(rig);
            rig.team().stopAll();

            assertThat(rig.said()).noneMatch(line -> line.contains("failed"));
            assertThat(rig.lab().simulators().bumps())
                    .allSatisfy((robot, bumps) -> assertThat(bumps).as(robot).isZero());
            assertThat(Arrays.stream(travelled).min().orElse(0)).isGreaterThan(FAR_MM);
        }
    }

    private static void wander(LabRig rig, int robot) {
        MajicParser parser = MajicParser.pipe(rig.session());
        for (String line : List.of(
                "repeat", "  " + robot + " move 2m until distanceFront < near", "  " + robot + " turn 100", "end")) {
            parser.parseText(line);
        }
    }

    /** Returns the true distance that each robot moved, mm, summed over seconds. */
    private static double[] watch(LabRig rig) throws InterruptedException {
        double[] travelled = new double[3];
        List<Pose> before = poses(rig);
        for (int second = 0; second < MINUTES * 60; second++) {
            rig.lab().time().sleep(1);
            List<Pose> now = poses(rig);
            for (int robot = 0; robot < travelled.length; robot++) {
                travelled[robot] += before.get(robot).distanceMm(now.get(robot));
            }
            before = now;
        }
        return travelled;
    }

    private static List<Pose> poses(LabRig rig) {
        Map<String, Pose> poses = rig.lab().truePoses();
        return new ArrayList<>(poses.values());
    }
}
