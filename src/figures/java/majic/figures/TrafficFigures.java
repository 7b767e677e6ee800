package majic.figures;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
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
final class TrafficFigures {
    private static final Path WORLD = Path.of("sims", "worlds", "office.map");
    private static final double NANOS = 1e9;
    private static final double ROOM_MM = 120;

    private final int count;
    private final double seconds;
    private final long seed;
    private final AtomicInteger reached = new AtomicInteger();
    private final Map<String, Integer> failures = Collections.synchronizedMap(new TreeMap<>());
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
                Pose place = place(random, space, taken);
                taken.add(place);
                rig.lab().place(name, place);
            }
            rig.lab().time().sleep(0.5);
            for (String name : names) {
                MajicBot robot = rig.add(name);
                robot.place(rig.truePose(name));
                robots.add(robot);
            }
            rig.session().addListener(line -> {
                if (System.getProperty("verbose") != null && line.text().contains("place")) {
                    System.out.println(rig.lab().time().nanos() / NANOS + " " + line.text());
                }
            });
            rig.lab().time().sleep(1);
            int before = bumps(rig);
            long beganNanos = System.nanoTime();
            double endS = rig.lab().time().nanos() / NANOS + seconds;
            CountDownLatch left = new CountDownLatch(count);
            for (int index = 0; index < count; index++) {
                MajicBot robot = robots.get(index);
                String name = names.get(index);
                Random own = new Random(seed * 1000 + index);
                rig.lab()
                        .time()
                        .thread("driver " + name, () -> {
                            drive(rig, robot, name, navigator, space, own, endS);
                            left.countDown();
                        })
                        .start();
            }
            int shown = 0;
            while (left.getCount() > 0) {
                rig.lab().time().sleep(5);
                int bumped = bumps(rig) - before;
                if (bumped != shown && System.getProperty("verbose") != null) {
                    shown = bumped;
                    System.out.println(rig.lab().time().nanos() / NANOS + " bumps "
                            + rig.lab().bumps());
                }
            }
            double minutes = (System.nanoTime() - beganNanos) / NANOS / 60;
            Collections.sort(times);
            return List.of(String.format(
                    Locale.ROOT,
                    "%d robots, %.0f s: %d goals reached, %d contacts, longest wait %.0f s, %.1f min; time of a goal %.0f s, longest %.0f s; failures %s",
                    count,
                    seconds,
                    reached.get(),
                    bumps(rig) - before,
                    0.0,
                    minutes,
                    times.get(times.size() / 2),
                    times.get(times.size() - 1),
                    failures));
        }
    }

    private static int bumps(LabRig rig) {
        return rig.lab().bumps().values().stream().mapToInt(Integer::intValue).sum();
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

    private void drive(
            LabRig rig, MajicBot robot, String name, Navigator navigator, FreeSpace space, Random random, double endS) {
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
                    if (System.getProperty("verbose") != null) {
                        System.out.println(time.nanos() / NANOS + " " + name + " to " + goal + ": " + e.getMessage()
                                + " at " + rig.truePose(name) + " believed "
                                + robot.state().pose());
                    }
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
