package majic.inlab.acts;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongFunction;
import java.util.function.Supplier;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majic.lab.LabAccess;
import majicsim.LabOptions;
import org.junit.jupiter.api.Named;

/** Provides the labs in which every shipped behaviour is tested, and the measurements there. */
public final class ActLabs {
    private static final int SEEDS = 5;
    private static final boolean ALL_SEEDS =
            System.getProperty("majic.seeds", "").equals("all");
    private static final double METRE_MM = 1000;

    private ActLabs() {}

    /**
     * Returns a lab with noise; with {@code -Dmajic.seeds=all}, as {@code ./check --full} sets it, a lab without noise
     * and five with it.
     */
    public static Stream<Named<Supplier<LabRig>>> labs() {
        return labs(SEEDS);
    }

    /** Returns the same with another number of labs with noise. */
    public static Stream<Named<Supplier<LabRig>>> labs(int seeds) {
        return labs(LabRig::exact, LabRig::noisy, seeds);
    }

    /** Returns the same labs, each with two Pioneers. */
    public static Stream<Named<Supplier<LabRig>>> labsWithTwoPioneers() {
        LabOptions two = LabOptions.exactOnFreePorts().withPioneers(2);
        return labs(() -> LabRig.of(two), seed -> LabRig.of(two.withNoise(seed)), SEEDS);
    }

    private static Stream<Named<Supplier<LabRig>>> labs(Supplier<LabRig> exact, LongFunction<LabRig> noisy, int seeds) {
        Stream<Named<Supplier<LabRig>>> withNoise = LongStream.rangeClosed(1, ALL_SEEDS ? seeds : 1)
                .mapToObj(seed -> Named.of("noisy lab " + seed, () -> noisy.apply(seed)));
        return ALL_SEEDS ? Stream.concat(Stream.of(Named.of("an exact lab", exact)), withNoise) : withNoise;
    }

    /** Returns a lab with one robot connected, as number 1. */
    public static LabRig with(Supplier<LabRig> lab, String type) {
        LabRig rig = lab.get();
        rig.add(type);
        return rig;
    }

    /** Moves a robot by hand to another place. */
    public static void place(LabRig rig, String robot, Pose where) {
        rig.lab().simulators().place(robot, new majicsim.world.Pose(where.xMm(), where.yMm(), where.headingDeg()));
    }

    /** Waits until a message appears, at most a minute. */
    public static void awaitSaid(LabRig rig, String words) throws InterruptedException {
        for (int tenth = 0; tenth < 600 && !rig.said().contains(words); tenth++) {
            rig.lab().time().sleep(0.1);
        }
    }

    /** Lets time pass and returns the robots' poses after each second. */
    public static Map<String, List<Pose>> watch(LabRig rig, int seconds) throws InterruptedException {
        Map<String, List<Pose>> ways = new LinkedHashMap<>();
        for (int second = 0; second < seconds; second++) {
            rig.lab().time().sleep(1);
            rig.lab()
                    .truePoses()
                    .forEach((robot, pose) -> ways.computeIfAbsent(robot, key -> new ArrayList<>())
                            .add(pose));
        }
        return ways;
    }

    /** Returns in how many squares of one metre a robot has been. */
    public static long metresVisited(List<Pose> way) {
        return way.stream()
                .map(pose -> List.of(Math.floor(pose.xMm() / METRE_MM), Math.floor(pose.yMm() / METRE_MM)))
                .distinct()
                .count();
    }

    /** Returns the distance from the middle of a robot to the nearest wall or box, mm. */
    public static double toTheWalls(LabRig rig, Pose pose) {
        return rig.lab().walls().stream()
                .mapToDouble(wall -> toTheWall(wall, pose))
                .min()
                .orElseThrow();
    }

    private static double toTheWall(LabAccess.Wall wall, Pose pose) {
        double dx = wall.x2() - wall.x1();
        double dy = wall.y2() - wall.y1();
        double along = ((pose.xMm() - wall.x1()) * dx + (pose.yMm() - wall.y1()) * dy) / (dx * dx + dy * dy);
        double share = Math.max(0, Math.min(along, 1));
        return Math.hypot(pose.xMm() - wall.x1() - share * dx, pose.yMm() - wall.y1() - share * dy);
    }

    /** Returns the number of collisions of each robot. */
    public static Map<String, Integer> bumps(LabRig rig) {
        return rig.lab().simulators().bumps();
    }
}
