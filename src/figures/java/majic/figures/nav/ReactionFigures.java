package majic.figures.nav;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import majic.bot.DriveGuard;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.figures.Measurement;
import majic.inlab.LabRig;
import majic.time.TimeSource;
import majicsim.LabOptions;
import majicsim.LabPorts;
import majicsim.ros.options.RosOptions;
import majicsim.world.Room;
import net.bytebuddy.agent.ByteBuddyAgent;

/**
 * Puts another robot, which is not in the team, in front of a robot that drives along a corridor of the office, at the
 * distance in which it can just stop: the time of the lab from the first report that shows it to the first bytes of a
 * lower speed on the link, and the processor time of the decision; each in ms, as median, the value that 95 of 100 do
 * not exceed, and the largest.
 */
public final class ReactionFigures {
    private static final Path WORLD = Path.of("sims", "worlds", "office.map");
    private static final String OBSTACLE = "pioneer2";
    private static final Pose WEST = new Pose(-8600, -6000, 0);
    private static final Pose EAST = new Pose(8600, -6000, 180);
    private static final Pose AWAY = new Pose(5000, 2500, 0);
    private static final double OBSTACLE_MM = 300;

    /** An echo as near to the centre of the obstacle is of it: that of a sonar may be on the side of its beam. */
    private static final double ECHO_MM = 450;

    private static final double STEP_S = 0.012;
    private static final double LONGEST_S = 3;
    private static final double MS = 1e6;

    private final String kind;
    private final int trials;
    private final Random random;
    private final List<Double> reactions = new ArrayList<>();
    private final List<Double> decisions = new ArrayList<>();
    private volatile Pose obstacle = AWAY;
    private volatile long shownNanos = -1;
    private int unnoticed;

    private ReactionFigures(String kind, int trials, long seed) {
        this.kind = kind;
        this.trials = trials;
        this.random = new Random(seed);
    }

    private List<String> measure() throws IOException, InterruptedException {
        LabOptions options = LabOptions.standard()
                .withPorts(LabPorts.FREE)
                .withRoom(Room.load(WORLD))
                .withNoise(1)
                .withPioneer(kind.equals("laser") ? "p3dx-sh+laser" : "p3dx-sh")
                .withPioneers(2);
        if (kind.equals("ros")) {
            options = options.withRos(RosOptions.parse("2").withoutNavigation());
        }
        String name = kind.equals("ros") ? "ros" : "pioneer";
        try (LabRig rig = LabRig.of(options)) {
            rig.session().map().open(WORLD);
            ReactionProbe.use(rig.lab().time());
            rig.lab().place(OBSTACLE, AWAY);
            MajicBot robot = rig.add(name);
            robot.addScanListener(scan -> lookAt(scan, robot, rig.lab().time()));
            for (int trial = 0; trial < trials; trial++) {
                one(rig, robot, name, trial % 2 == 0);
            }
            return List.of(String.format(
                    Locale.ROOT,
                    "| %s | %d of %d | %s | %s | %d |",
                    kind,
                    reactions.size(),
                    reactions.size() + unnoticed,
                    GoToFigures.spread(reactions),
                    GoToFigures.spread(decisions),
                    rig.lab().bumps().getOrDefault(name, 0)));
        }
    }

    /** Notes the first scan of the obstacle. */
    private void lookAt(RangeScan scan, MajicBot robot, TimeSource time) {
        if (obstacle == AWAY || shownNanos >= 0) {
            return;
        }
        Pose here = robot.odometryOrigin().plus(scan.odometry());
        for (int beam = 0; beam < scan.size(); beam++) {
            float range = scan.rangeMm(beam);
            Pose sensor = here.plus(scan.sensor().beams().get(beam).mount());
            if (Float.isFinite(range) && sensor.after(range, 0).distanceMm(obstacle) < ECHO_MM) {
                shownNanos = time.nanos();
                ReactionProbe.arm();
                return;
            }
        }
    }

    private void one(LabRig rig, MajicBot robot, String name, boolean eastward) throws InterruptedException {
        rig.lab().place(OBSTACLE, AWAY);
        rig.lab().place(name, eastward ? WEST : EAST);
        rig.lab().time().sleep(1);
        robot.place(rig.truePose(name));
        Pose goal = eastward ? EAST : WEST;
        rig.say(String.format(Locale.ROOT, "1 goto %.0f %.0f", goal.xMm(), goal.yMm()));
        rig.lab().time().sleep(6 + 12 * random.nextDouble());
        Pose here = rig.truePose(name);
        double cruise = robot.state().speedMmPerSec();
        double ahead = robot.profile().bodyMm() + OBSTACLE_MM + DriveGuard.Room.brakingMm(cruise);
        Pose there = here.after(ahead, 0);
        shownNanos = -1;
        obstacle = there;
        rig.lab().place(OBSTACLE, there);
        double endS = seconds(rig) + LONGEST_S;
        while (ReactionProbe.writtenNanos() < 0 && seconds(rig) < endS) {
            rig.lab().time().sleep(STEP_S);
        }
        if (shownNanos >= 0 && ReactionProbe.writtenNanos() >= 0) {
            reactions.add((ReactionProbe.writtenNanos() - shownNanos) / MS);
            decisions.add(1e3 * ReactionProbe.decidingS());
        } else {
            unnoticed++;
        }
        obstacle = AWAY;
        rig.lab().time().sleep(1);
        ReactionProbe.disarm();
        rig.run("1 stop");
    }

    private static double seconds(LabRig rig) {
        return rig.lab().time().nanos() / 1e9;
    }

    /** Measures laser, sonar or ros; the number of obstacles; the seed. */
    public static void main(String[] arguments) {
        ReactionProbe.install(ByteBuddyAgent.install());
        Measurement.run(
                () -> new ReactionFigures(arguments[0], Integer.parseInt(arguments[1]), Long.parseLong(arguments[2]))
                        .measure());
    }
}
