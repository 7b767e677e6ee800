package majic.figures;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import java.util.stream.IntStream;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majic.link.Loopback;
import majicsim.LabOptions;
import majicsim.LabPorts;
import majicsim.mavlink.MavlinkOptions;
import majicsim.world.Room;

/**
 * Measures the driver of MAVLink vehicles: the time from STOP to its bytes at 20 vehicles on one UDP port, the error of
 * motions of the simulated rover by its true place, with the usual noise, and what vehicles that report cost.
 */
public final class MavlinkFigures {
    private static final Path WORLD = Path.of("sims", "worlds", "office.map");
    private static final Pose START = new Pose(-7000, -6000, 0);
    private static final int RUNS = 20;
    private static final double MOVE_MM = 5000;
    private static final double TURN_DEG = 90;
    private static final int VEHICLES = 20;
    private static final int ROUNDS = 50;
    private static final int WARMING = 10;
    private static final double WANTED_MS = 20;
    private static final int MOST_STOP_S = 10;
    private static final int SETTLING_S = 15;
    private static final int MEASURED_S = 20;

    private MavlinkFigures() {}

    /**
     * Measures one figure.
     *
     * @param arguments {@code motion}, {@code stop}, or the addresses of robots whose cost is to be measured
     */
    public static void main(String[] arguments) {
        Measurement.run(() -> switch (arguments[0]) {
            case "motion" -> motion();
            case "stop" -> stop();
            default -> load(List.of(arguments));
        });
    }

    private static List<String> motion() throws IOException, InterruptedException {
        List<Double> along = new ArrayList<>();
        List<Double> aside = new ArrayList<>();
        List<Double> turned = new ArrayList<>();
        List<String> failures = new ArrayList<>();
        for (int seed = 1; seed <= RUNS; seed++) {
            LabOptions options = LabOptions.standard()
                    .withPorts(LabPorts.FREE)
                    .withRoom(Room.load(WORLD))
                    .withNoise(seed)
                    .withMavlink(MavlinkOptions.parse("rover+ready"));
            try (LabRig rig = LabRig.of(options)) {
                rig.lab().place("mavlink", START);
                MajicBot rover = rig.add("mavlink");
                rig.lab().time().sleep(2);
                rover.run("arm", List.of());
                Pose from = rig.truePose("mavlink");
                attempt(failures, () -> rover.move(MOVE_MM));
                Pose moved = rig.truePose("mavlink");
                attempt(failures, () -> rover.turn(TURN_DEG));
                Pose there = rig.truePose("mavlink");
                along.add(Math.abs(from.aheadMm(moved) - MOVE_MM));
                aside.add(
                        Math.sqrt(Math.max(0, Math.pow(from.distanceMm(moved), 2) - Math.pow(from.aheadMm(moved), 2))));
                turned.add(Math.abs(Pose.normalised(there.headingDeg() - moved.headingDeg() - TURN_DEG)));
            }
        }
        return List.of(
                "move 5000: error of the distance " + spread(along) + " mm, to the side " + spread(aside) + " mm",
                "turn 90: error " + spread(turned) + " deg",
                "failed: " + failures.size() + " of " + 2 * RUNS + " " + failures);
    }

    private static void attempt(List<String> failures, Runnable motion) {
        try {
            motion.run();
        } catch (MotionFailed e) {
            failures.add(e.getMessage());
        }
    }

    private static String spread(List<Double> values) {
        Collections.sort(values);
        return String.format(
                Locale.ROOT, "median %.1f, largest %.1f", values.get(values.size() / 2), values.get(values.size() - 1));
    }

    private static List<String> stop() throws IOException, InterruptedException, ExecutionException {
        int port = Loopback.freePort();
        List<Double> delaysMs = new ArrayList<>();
        int late = 0;
        try (SilentVehicles vehicles = new SilentVehicles(port, VEHICLES);
                ConnectedTeam robots = new ConnectedTeam(VEHICLES)) {
            robots.connect(IntStream.rangeClosed(1, VEHICLES)
                    .mapToObj(system -> "mavlink:udp://:" + port + "?system=" + system)
                    .toList());
            for (int round = 0; round < WARMING + ROUNDS; round++) {
                vehicles.forget();
                long began = System.nanoTime();
                robots.team().stopAll();
                for (int waited = 0; waited < MOST_STOP_S * 100 && !vehicles.areAllStopped(); waited++) {
                    Thread.sleep(10);
                }
                if (round >= WARMING) {
                    List<Double> ofRound = vehicles.arrivals().stream()
                            .map(nanos -> (nanos - began) / 1e6)
                            .toList();
                    delaysMs.addAll(ofRound);
                    late += ofRound.stream().anyMatch(delay -> delay > WANTED_MS) ? 1 : 0;
                }
                Thread.sleep(500);
            }
        }
        Collections.sort(delaysMs);
        return List.of(String.format(
                Locale.ROOT,
                "%d stops of %d: median %.1f ms, 99 of 100 within %.1f ms, longest %.1f ms; %d of %d rounds with one above %.0f ms",
                delaysMs.size(),
                ROUNDS * VEHICLES,
                delaysMs.get(delaysMs.size() / 2),
                delaysMs.get((int) Math.ceil(0.99 * delaysMs.size()) - 1),
                delaysMs.get(delaysMs.size() - 1),
                late,
                ROUNDS,
                WANTED_MS));
    }

    private static List<String> load(List<String> addresses) throws InterruptedException, ExecutionException {
        try (ConnectedTeam robots = new ConnectedTeam(addresses.size())) {
            robots.connect(addresses);
            Thread.sleep(1000 * SETTLING_S);
            ProcessSample began = ProcessSample.now();
            Thread.sleep(1000 * MEASURED_S);
            double percent = ProcessSample.now().percentSince(began);
            return List.of(String.format(
                    Locale.ROOT,
                    "%d %s: %.2f %% of a core, each %.3f %%",
                    addresses.size(),
                    addresses.get(0).replaceFirst(":.*", ""),
                    percent,
                    percent / addresses.size()));
        }
    }
}
