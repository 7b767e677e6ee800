package majic.figures.nav;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.figures.Measurement;
import majic.inlab.LabRig;
import majic.nav.Destination;
import majic.nav.Navigator;
import majic.nav.path.FreeSpace;
import majic.nav.path.ObstacleDistance;
import majic.time.TimeSource;
import majicsim.LabOptions;
import majicsim.LabPorts;
import majicsim.world.Room;

/** Lets many Pioneers of the lab drive to random places of the office at the same time, with the usual noise. */
public final class TrafficFigures {
    private static final Path WORLD = Path.of("sims", "worlds", "office.map");
    private static final double NANOS = 1e9;
    private static final double ROOM_MM = 120;

    private final int count;
    private final double seconds;
    private final long seed;
    private final AtomicInteger reached = new AtomicInteger();
    private final Map<String, Integer> failures = Collections.synchronizedMap(new TreeMap<>());
    private final Map<MajicBot, Long> waitingSince = new HashMap<>();
    private double longestWaitS;
    private final List<Double> times = Collections.synchronizedList(new ArrayList<>());

    private TrafficFigures(int count, double seconds, long seed) {
        this.count = count;
        this.seconds = seconds;
        this.seed = seed;
    }

    private List<String> measure() throws IOException, InterruptedException {
        LabOptions options = LabOptions.standard()
                .withPorts(LabPorts.FREE)
                .withRoom(Room.load(WORLD))
                .withNoise(seed)
                .withPioneer("p3dx-sh+laser")
                .withPioneers(count);
        try (LabRig rig = LabRig.of(options)) {
            rig.session().map().open(WORLD);
            Navigator navigator = rig.session().map().navigator();
            FreeSpace space =
                    new FreeSpace(new ObstacleDistance(rig.session().map().get().orElseThrow()), 368, List.of());
            Random random = new Random(seed);
            List<String> names = rig.lab().robots().stream()
                    .filter(name -> name.startsWith("pioneer"))
                    .toList();
            List<Pose> taken = new ArrayList<>(List.of(rig.truePose("aibo"), rig.truePose("hemisson")));
            List<MajicBot> robots = new ArrayList<>();
            for (String name : names) {
                taken.add(placed(rig, name, random, space, taken));
            }
            rig.lab().time().sleep(0.5);
            for (String name : names) {
                MajicBot robot = rig.add(name);
                robot.place(rig.truePose(name));
                robots.add(robot);
            }
            rig.lab().time().sleep(1);
            int before = bumps(rig);
            double endS = rig.lab().time().nanos() / NANOS + seconds;
            CountDownLatch left = new CountDownLatch(count);
            for (int index = 0; index < count; index++) {
                MajicBot robot = robots.get(index);
                String name = names.get(index);
                Random own = new Random(seed * 1000 + index);
                rig.lab()
                        .time()
                        .thread("driver " + name, () -> {
                            drive(rig, robot, navigator, space, own, endS);
                            left.countDown();
                        })
                        .start();
            }
            while (left.getCount() > 0) {
                rig.lab().time().sleep(1);
                robots.forEach(robot -> noteWait(navigator, robot, rig.lab().time()));
            }
            Collections.sort(times);
            return List.of(String.format(
                    Locale.ROOT,
                    "%d robots, %.0f s: %d goals reached, %d contacts, longest wait %.0f s; time of a goal %.0f s, longest"
                            + " %.0f s; failures %s",
                    count,
                    seconds,
                    reached.get(),
                    bumps(rig) - before,
                    longestWaitS,
                    times.get(times.size() / 2),
                    times.get(times.size() - 1),
                    failures));
        }
    }

    private void noteWait(Navigator navigator, MajicBot robot, TimeSource time) {
        if (navigator.waits(robot).isEmpty()) {
            waitingSince.remove(robot);
        } else {
            long since = waitingSince.computeIfAbsent(robot, waits -> time.nanos());
            longestWaitS = Math.max(longestWaitS, time.secondsSince(since));
        }
    }

    private static int bumps(LabRig rig) {
        return rig.lab().bumps().values().stream().mapToInt(Integer::intValue).sum();
    }

    /** Puts a robot anywhere; the lab refuses a place where another one is that has not been put elsewhere yet. */
    private static Pose placed(LabRig rig, String name, Random random, FreeSpace space, List<Pose> taken) {
        while (true) {
            Pose place = place(random, space, taken);
            try {
                rig.lab().place(name, place);
                return place;
            } catch (BotException e) {
                continue;
            }
        }
    }

    private static Pose place(Random random, FreeSpace space, List<Pose> taken) {
        while (true) {
            Pose place = new Pose(
                    random.nextDouble() * 19_400 - 9700,
                    random.nextDouble() * 13_400 - 6700,
                    random.nextInt(360) - 179);
            if (space.mm(place.xMm(), place.yMm()) > ROOM_MM
                    && taken.stream().noneMatch(other -> other.distanceMm(place) < 1000)) {
                return place;
            }
        }
    }

    private void drive(LabRig rig, MajicBot robot, Navigator navigator, FreeSpace space, Random random, double endS) {
        TimeSource time = rig.lab().time();
        try {
            while (time.nanos() / NANOS < endS) {
                Pose goal = place(random, space, List.of());
                double beganS = time.nanos() / NANOS;
                try {
                    navigator.goTo(robot, new Destination(goal, false));
                    reached.incrementAndGet();
                    times.add(time.nanos() / NANOS - beganS);
                } catch (BotException e) {
                    failures.merge(String.valueOf(e.getMessage()).replaceAll("-?\\d+", "N"), 1, Integer::sum);
                }
                time.sleep(1);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Measures with a number of robots, for some seconds of the lab, with a seed. */
    public static void main(String[] arguments) {
        Measurement.run(() -> new TrafficFigures(
                        Integer.parseInt(arguments[0]), Double.parseDouble(arguments[1]), Long.parseLong(arguments[2]))
                .measure());
    }
}
