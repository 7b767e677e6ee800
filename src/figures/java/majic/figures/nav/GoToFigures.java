package majic.figures.nav;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.figures.Measurement;
import majic.inlab.LabRig;
import majic.nav.Destination;
import majic.nav.Navigator;
import majic.nav.grid.NavigationMap;
import majic.nav.path.FreeSpace;
import majic.nav.path.ObstacleDistance;
import majicsim.LabOptions;
import majicsim.LabPorts;
import majicsim.ros.options.RosOptions;
import majicsim.world.Room;

/**
 * Sends one robot of the lab to many places of the office, with the usual noise, on the stepped clock, while two others
 * drive about that do not know of it: how many it reaches, contacts, the length of its ways against the shortest ones
 * between the walls, the time against these at cruising speed, and how far it is from the goal by its true place, mm
 * and deg, and what the thread of the motion takes of a core, percent; each as median, the value that 95 of 100 do not
 * exceed, and the largest.
 */
public final class GoToFigures {
    private static final Path WORLD = Path.of("sims", "worlds", "office.map");
    private static final double NANOS = 1e9;
    private static final double ROOM_MM = 80;
    private static final double LEAST_MM = 500;

    /** Other robots that go from place to place, outside of the team of the one that is measured. */
    private static final List<String> MOVERS = List.of("pioneer2", "pioneer3");

    private final String kind;
    private final int goals;
    private final long seed;
    private final Random random;
    private final List<Double> lengths = new ArrayList<>();
    private final List<Double> times = new ArrayList<>();
    private final List<Double> errors = new ArrayList<>();
    private final List<Double> turns = new ArrayList<>();
    private final List<Double> loads = new ArrayList<>();
    private final Map<String, Integer> failures = new TreeMap<>();
    private int reached;

    private GoToFigures(String kind, int goals, long seed) {
        this.kind = kind;
        this.goals = goals;
        this.seed = seed;
        this.random = new Random(seed);
    }

    private List<String> measure() throws IOException, InterruptedException {
        LabOptions options = LabOptions.standard()
                .withPorts(LabPorts.FREE)
                .withRoom(Room.load(WORLD))
                .withNoise(seed)
                .withPioneer(kind.equals("sonar") ? "p3dx-sh" : "p3dx-sh+laser")
                .withPioneers(1 + MOVERS.size());
        if (kind.equals("ros")) {
            options = options.withRos(RosOptions.parse("2").withoutNavigation());
        }
        String name = Map.of("laser", "pioneer", "sonar", "pioneer").getOrDefault(kind, kind);
        try (LabRig rig = LabRig.of(options)) {
            rig.session().map().open(WORLD);
            NavigationMap map = rig.session().map().get().orElseThrow();
            Navigator navigator = new Navigator(rig.session().map()::get);
            MajicBot robot = rig.add(name);
            robot.set("maxMove", 100_000);
            robot.place(rig.truePose(name));
            navigator.add(robot);
            FreeSpace space =
                    new FreeSpace(new ObstacleDistance(map), robot.profile().bodyMm(), standing(rig, name));
            ShortestWays shortest =
                    new ShortestWays(rig.lab().walls(), robot.profile().bodyMm());
            move(rig, map);
            rig.lab().time().sleep(1);
            Driven driven = new Driven(rig, name);
            robot.addListener(driven);
            for (int goal = 0; goal < goals; goal++) {
                one(rig, name, robot, navigator, space, shortest, driven);
            }
            return List.of(
                    String.format(
                                    Locale.ROOT,
                                    "| %s | %d of %d | %d | ",
                                    kind,
                                    reached,
                                    goals,
                                    rig.lab().bumps().getOrDefault(name, 0))
                            + String.join(
                                    " | ", spread(lengths), spread(times), spread(errors), spread(turns), spread(loads))
                            + " |",
                    "failures: " + failures);
        }
    }

    /** How far a robot is sent that goes by its odometry alone: as far as that is good for. */
    private double mostMm() {
        return switch (kind) {
            case "aibo" -> 3000;
            case "hemisson" -> 1000;
            default -> Double.POSITIVE_INFINITY;
        };
    }

    private static List<FreeSpace.Disc> standing(LabRig rig, String name) {
        return rig.lab().truePoses().entrySet().stream()
                .filter(entry -> !entry.getKey().equals(name) && !MOVERS.contains(entry.getKey()))
                .map(entry -> new FreeSpace.Disc(
                        entry.getValue().xMm(), entry.getValue().yMm(), 300))
                .toList();
    }

    /** Sends the other robots to random places, each by a navigator that knows no other robot, until the end. */
    private void move(LabRig rig, NavigationMap map) {
        for (String name : MOVERS) {
            MajicBot mover = rig.add(name);
            mover.set("maxMove", 100_000);
            mover.place(rig.truePose(name));
            Navigator navigator = new Navigator(() -> Optional.of(map));
            Random places = new Random(seed + MOVERS.indexOf(name) + 1);
            rig.lab()
                    .time()
                    .thread("mover " + name, () -> wander(rig, mover, navigator, places))
                    .start();
        }
    }

    private static void wander(LabRig rig, MajicBot mover, Navigator navigator, Random places) {
        try {
            while (true) {
                try {
                    navigator.goTo(mover, new Destination(randomPlace(places), false));
                } catch (BotException e) {
                    rig.lab().time().sleep(1);
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static Pose randomPlace(Random places) {
        return new Pose(
                places.nextDouble() * 19_400 - 9700, places.nextDouble() * 13_400 - 6700, places.nextInt(360) - 179);
    }

    /** The way that the robot really drove. */
    private static final class Driven implements BotListener {
        private final LabRig rig;
        private final String name;
        private Pose last;
        private double mm;

        Driven(LabRig rig, String name) {
            this.rig = rig;
            this.name = name;
            this.last = rig.truePose(name);
        }

        @Override
        public synchronized void stateChanged(MajicBot bot, BotState state) {
            Pose now = rig.truePose(name);
            if (now.distanceMm(last) > 20) {
                mm += now.distanceMm(last);
                last = now;
            }
        }

        synchronized double take() {
            double taken = mm;
            mm = 0;
            return taken;
        }
    }

    private void one(
            LabRig rig,
            String name,
            MajicBot robot,
            Navigator navigator,
            FreeSpace space,
            ShortestWays ways,
            Driven driven)
            throws InterruptedException {
        Pose from = rig.truePose(name);
        Pose to;
        double shortestMm;
        do {
            to = randomPlace(random);
            boolean fits = from.distanceMm(to) < mostMm() && space.mm(to.xMm(), to.yMm()) >= ROOM_MM;
            shortestMm = fits ? ways.mm(from, to) : Double.POSITIVE_INFINITY;
        } while (shortestMm == Double.POSITIVE_INFINITY || shortestMm < LEAST_MM || shortestMm > mostMm());
        driven.take();
        double beganS = rig.lab().time().nanos() / NANOS;
        long beganOfCore = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        try {
            navigator.goTo(robot, new Destination(to, true));
            reached++;
            double tookS = rig.lab().time().nanos() / NANOS - beganS;
            loads.add(100
                    * (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - beganOfCore)
                    / NANOS
                    / tookS);
            rig.lab().time().sleep(0.5);
            Pose there = rig.truePose(name);
            lengths.add(driven.take() / shortestMm);
            times.add(tookS / (shortestMm / robot.get("cruise").number()));
            errors.add(there.distanceMm(to));
            turns.add(Math.abs(Pose.normalised(there.headingDeg() - to.headingDeg())));
        } catch (BotException e) {
            failures.merge(String.valueOf(e.getMessage()).replaceAll("-?\\d+", "N"), 1, Integer::sum);
            rig.lab().time().sleep(1);
            robot.place(rig.truePose(name));
        }
        if (!kind.equals("laser") && !kind.equals("sonar") && !kind.equals("ros")) {
            robot.place(rig.truePose(name));
        }
    }

    static String spread(List<Double> values) {
        if (values.isEmpty()) {
            return "-";
        }
        double[] sorted = values.stream().mapToDouble(Double::doubleValue).toArray();
        Arrays.sort(sorted);
        return String.format(
                Locale.ROOT,
                "%.2f / %.2f / %.2f",
                sorted[sorted.length / 2],
                sorted[(int) (sorted.length * 0.95)],
                sorted[sorted.length - 1]);
    }

    /** Measures a kind of robot: laser, sonar, ros, aibo or hemisson; the number of goals; the seed. */
    public static void main(String[] arguments) {
        Measurement.run(() ->
                new GoToFigures(arguments[0], Integer.parseInt(arguments[1]), Long.parseLong(arguments[2])).measure());
    }
}
