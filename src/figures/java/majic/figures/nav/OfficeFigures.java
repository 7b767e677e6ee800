package majic.figures.nav;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.figures.Measurement;
import majic.inlab.LabRig;
import majic.simulation.SimulatedLab;
import majicsim.LabOptions;
import majicsim.LabPorts;
import majicsim.world.Room;

/**
 * Builds a map of an office of the lab, with its usual noise, on its stepped clock: a Pioneer with a laser drives
 * around the corridor and into the rooms, past another one that drives the other way round. Or localises a Pioneer on
 * the true map on the same way, by its laser or by its sonars alone.
 */
public final class OfficeFigures {
    private static final Path WORLD = Path.of("sims", "worlds", "office.map");
    private static final String LOCALISATION = "localisation";
    private static final long SEED = 1;
    private static final String WITH_LASER = "p3dx-sh+laser";
    private static final String WITH_SONARS = "p3dx-sh";
    private static final String MAPPER = "pioneer";
    private static final String OTHER = "pioneer2";
    private static final double STEP_S = 0.1;
    private static final double MOST_S = 900;
    private static final double NANOS = 1e9;
    private static final int ROUNDS_OF_OTHER = 20;

    /** x and y in mm: on the right of the corridor, counterclockwise, and into each room by its door. */
    private static final int[] WAY = {
        -5000, -6300, -5000, -3400, -5000, -6300, 0, -6300, 0, -4300, 0, -6300, 5000, -6300, 5000, -3800, 4000, -2600,
        5000, -3800, 5000, -6300, 9300, -6300, 9300, 6300, 3500, 6300, 3500, 1500, 3500, 6300, -3000, 6300, -3000, 3600,
        -2300, 2000, -3000, 3600, -3000, 6300, -9300, 6300, -9300, -6300, 5000, -6300
    };

    /** On the right of the corridor too, clockwise. */
    private static final int[] WAY_OF_OTHER = {8500, 5500, 8500, -5500, -8500, -5500, -8500, 5500};

    private final long seed;

    /** Where the other robots were, at each step. */
    private final List<Pose> others = new ArrayList<>();

    private OfficeFigures(long seed) {
        this.seed = seed;
    }

    private LabRig office(String model) throws IOException {
        return LabRig.of(LabOptions.standard()
                .withPorts(LabPorts.FREE)
                .withRoom(Room.load(WORLD))
                .withNoise(seed)
                .withPioneer(model)
                .withPioneers(2));
    }

    private List<String> measure() throws IOException, InterruptedException {
        try (LabRig rig = office(WITH_LASER)) {
            MajicBot robot = rig.add(MAPPER);
            ScanLoad load = new ScanLoad(rig.lab().time());
            robot.place(rig.truePose(MAPPER));
            // Before that of the map, so that it counts the scans before.
            robot.addScanListener(load);
            rig.run("map start 1");
            double lastedS = drive(rig.lab(), robot, rig.add(OTHER), truth -> {});
            load.count();
            String text = rig.run("map").get(0);
            double wrongMm = robot.state().pose().distanceMm(rig.truePose(MAPPER));
            rig.run("map stop");
            int bumps = rig.lab().bumps().values().stream()
                    .mapToInt(Integer::intValue)
                    .sum();
            return List.of(
                    String.format(
                            Locale.ROOT,
                            "%.0f s with the noise %d, %d bumps, the place at the end %.0f mm wrong; %s",
                            lastedS,
                            seed,
                            bumps,
                            wrongMm,
                            text),
                    new WallErrors(
                                    rig.session().map().get().orElseThrow().grid(),
                                    rig.lab().walls(),
                                    others)
                            .text(),
                    load.text());
        }
    }

    /** A row: how far the place of a robot on the true map is from the truth, from when it was placed. */
    private String localise(String model) throws IOException, InterruptedException {
        try (LabRig rig = office(model)) {
            MajicBot robot = rig.add(MAPPER);
            Pose start = rig.truePose(MAPPER);
            rig.run(
                    "map open " + WORLD,
                    String.format(
                            Locale.ROOT, "1 set pose %.0f %.0f %.0f", start.xMm(), start.yMm(), start.headingDeg()));
            PlaceErrors errors = new PlaceErrors(robot, start);
            drive(rig.lab(), robot, rig.add(OTHER), errors::add);
            return String.format(Locale.ROOT, "| %d | %s | %s |", seed, model, errors.text());
        }
    }

    /** Drives until the way is done; {@code observer} receives the true pose of the robot at each step. */
    private double drive(SimulatedLab lab, MajicBot robot, MajicBot other, Consumer<Pose> observer)
            throws InterruptedException {
        OfficeTour tour = new OfficeTour(robot, poses(WAY, 1));
        OfficeTour otherTour = new OfficeTour(other, poses(WAY_OF_OTHER, ROUNDS_OF_OTHER));
        double beganS = seconds(lab);
        boolean driving = true;
        while (driving) {
            Map<String, Pose> truth = lab.truePoses();
            truth.entrySet().stream()
                    .filter(entry -> !entry.getKey().equals(MAPPER))
                    .forEach(entry -> others.add(entry.getValue()));
            otherTour.step(truth.get(OTHER));
            observer.accept(truth.get(MAPPER));
            driving = tour.step(truth.get(MAPPER)) && seconds(lab) - beganS < MOST_S;
            lab.time().sleep(STEP_S);
        }
        other.drive(0, 0);
        lab.time().sleep(1);
        return seconds(lab) - beganS;
    }

    private static double seconds(SimulatedLab lab) {
        return lab.time().nanos() / NANOS;
    }

    private static List<Pose> poses(int[] points, int rounds) {
        List<Pose> way = new ArrayList<>();
        for (int round = 0; round < rounds; round++) {
            for (int index = 0; index < points.length; index += 2) {
                way.add(new Pose(points[index], points[index + 1], 0));
            }
        }
        return way;
    }

    /** Measures with each of the seeds of the noise, or with one; localisation if the first word is that. */
    public static void main(String[] words) {
        Measurement.run(() -> {
            boolean localisation = words.length > 0 && words[0].equals(LOCALISATION);
            List<String> seeds = List.of(words).subList(localisation ? 1 : 0, words.length);
            List<String> rows = new ArrayList<>();
            for (String seed : seeds.isEmpty() ? List.of("" + SEED) : seeds) {
                OfficeFigures office = new OfficeFigures(Long.parseLong(seed));
                if (localisation) {
                    rows.add(office.localise(WITH_SONARS));
                    rows.add(office.localise(WITH_LASER));
                } else {
                    rows.addAll(office.measure());
                }
            }
            return rows;
        });
    }
}
