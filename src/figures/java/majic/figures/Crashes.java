package majic.figures;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import majic.bot.Pose;
import majic.program.Crash;
import majic.program.CrashingSession;
import majic.simulation.SimulatedLab;
import majic.stop.RecordingRelay;
import majicsim.LabOptions;

/**
 * Kills a session at random moments while its robots drive, and reports what its files have lost and how long the
 * robots drive on. All rounds use the same folder. The lab is in the program that measures, so that it survives.
 */
final class Crashes {
    private static final int ROUNDS = 50;
    private static final int SHORTEST_MS = 300;
    private static final int LONGEST_MS = 2500;
    private static final int WATCHED_MS = 4000;
    private static final int LOOK_MS = 20;
    private static final double STATIONARY_MM = 0.2;

    private final Path folder;
    private final SimulatedLab lab;
    private final Map<String, Pose> start;
    private final List<String> problems = new ArrayList<>();
    private final List<Integer> missingLines = new ArrayList<>();
    private final Map<String, List<Double>> stopped = new TreeMap<>();
    private final Map<String, Integer> drivingOn = new TreeMap<>();
    private int linesOfRecordings;

    private Crashes(Path folder, SimulatedLab lab) {
        this.folder = folder;
        this.lab = lab;
        this.start = lab.truePoses();
    }

    /** Kills {@value #ROUNDS} sessions. */
    static List<String> measure() throws IOException, InterruptedException {
        try (SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1)) {
            Crashes crashes = new Crashes(Files.createTempDirectory("majic-crash"), lab);
            Random moments = new Random(1);
            for (int round = 0; round < ROUNDS; round++) {
                crashes.crash(SHORTEST_MS + moments.nextInt(LONGEST_MS - SHORTEST_MS));
            }
            return crashes.report();
        }
    }

    /**
     * The Pioneer is at a serial port. This program keeps the port open too, since the wire of a real port stays when
     * the program at one end of it ends.
     */
    private void crash(int afterMs) throws IOException, InterruptedException {
        start.forEach(lab::place);
        try (RecordingRelay port = RecordingRelay.serial(portOf("pioneer"))) {
            InputStream wire = Files.newInputStream(Path.of(port.address()));
            try {
                Crash crash =
                        Crash.after(afterMs, folder, address("aibo"), "pioneer:" + port.address(), address("hemisson"));
                watch(crash.killedNanos());
                check(crash);
            } finally {
                wire.close();
            }
        }
    }

    private String address(String robot) {
        return lab.address(robot).orElseThrow().toString();
    }

    private int portOf(String robot) {
        return Integer.parseInt(address(robot).replaceFirst(".*:", ""));
    }

    private void check(Crash crash) {
        try {
            missingLines.add(crash.missingLines());
            linesOfRecordings += crash.recording().lines().size();
            int kept = Integer.parseInt(crash.settings().getProperty(CrashingSession.KEY, "-1"));
            if (kept < crash.reportedSetting()) {
                problems.add("setting " + kept + " in place of " + crash.reportedSetting());
            }
        } catch (IOException | RuntimeException e) {
            problems.add(String.valueOf(e));
        }
    }

    private void watch(long killedNanos) throws InterruptedException {
        Map<String, Pose> last = lab.truePoses();
        Map<String, Double> movedMs = new TreeMap<>();
        for (double nowMs = 0; nowMs < WATCHED_MS; nowMs = (System.nanoTime() - killedNanos) / 1e6) {
            Thread.sleep(LOOK_MS);
            Map<String, Pose> now = lab.truePoses();
            for (String robot : now.keySet()) {
                if (now.get(robot).distanceMm(last.get(robot)) > STATIONARY_MM) {
                    movedMs.put(robot, (System.nanoTime() - killedNanos) / 1e6);
                }
            }
            last = now;
        }
        movedMs.forEach((robot, ms) -> {
            if (ms > WATCHED_MS - 10 * LOOK_MS) {
                drivingOn.merge(robot, 1, Integer::sum);
            } else {
                stopped.computeIfAbsent(robot, key -> new ArrayList<>()).add(ms);
            }
        });
    }

    private List<String> report() {
        List<String> lines = new ArrayList<>();
        Collections.sort(missingLines);
        lines.add(ROUNDS + " kills; problems: " + (problems.isEmpty() ? "none" : problems));
        if (!missingLines.isEmpty()) {
            lines.add("session log: whole lines without a gap; lines shown but not yet in it: median "
                    + missingLines.get(missingLines.size() / 2) + ", most " + Collections.max(missingLines));
        }
        lines.add("recordings: each opens; " + linesOfRecordings + " lines of the session in them");
        for (String robot : start.keySet()) {
            List<Double> times = stopped.getOrDefault(robot, List.of());
            lines.add(String.format(
                    Locale.ROOT,
                    "%-9s came to rest %d times, after %.2f s at most; was still driving after %.0f s %d times",
                    robot,
                    times.size(),
                    times.isEmpty() ? 0 : Collections.max(times) / 1000,
                    WATCHED_MS / 1000.0,
                    drivingOn.getOrDefault(robot, 0)));
        }
        return lines;
    }
}
