package majic.figures;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.OptionalLong;
import java.util.concurrent.TimeUnit;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/**
 * One robot behind a rosbridge server, driven by MAJIC's driver and then by roslibpy, the usual client of Python, with
 * the subscriptions that the driver made: processor time of each program, and the time from a command to the arrival of
 * its bytes at a port in front of the server. The three programs read the same clock of the system.
 */
final class RosFigures {
    private static final Path CLIENT = Path.of("src", "test", "resources", "majic", "figures", "roslibpy_client.py");
    private static final String PYTHON = System.getenv().getOrDefault("PYTHON", "python3");

    private final ChildProgram programs;
    private final String host;
    private final int port;
    private final String rest;

    /**
     * Prepares a measurement.
     *
     * @param address the robot, such as {@code ros://127.0.0.1:9090/robot1}
     */
    RosFigures(ChildProgram programs, String address) {
        this.programs = programs;
        String[] parts = address.split("[/:]+", 4);
        this.host = parts[1];
        String[] portAndRest = parts[2].split("(?=[/?])", 2);
        this.port = Integer.parseInt(portAndRest[0]);
        this.rest = parts.length > 3 ? "/" + parts[3] : "";
    }

    /** Returns the lines of a table. */
    List<String> measure() throws IOException, InterruptedException {
        List<String> rows = new ArrayList<>();
        rows.add(row(
                "", "CPU reporting", "CPU driven", "drive: median", "99 %", "stop: median", "99 %", "KB/s received"));
        List<JsonNode> subscriptions;
        JsonNode velocity;
        try (RosTap tap = RosTap.of(host, port)) {
            long began = System.nanoTime();
            List<String> lines = programs.lines(RosDriver.class, List.of("ros://127.0.0.1:" + tap.port() + rest));
            rows.add(figures("MAJIC", lines, tap, began));
            subscriptions = tap.subscriptions();
            velocity = tap.velocityTopic();
        }
        if (!hasRoslibpy()) {
            rows.add("roslibpy is not installed for " + PYTHON
                    + ", so it was not measured: install it with pip, or name another Python in PYTHON");
            return rows;
        }
        try (RosTap tap = RosTap.of(host, port)) {
            long began = System.nanoTime();
            rows.add(figures("roslibpy", python(tap.port(), velocity, subscriptions), tap, began));
        }
        return rows;
    }

    private static boolean hasRoslibpy() throws IOException, InterruptedException {
        try {
            Process python = new ProcessBuilder(PYTHON, "-c", "import roslibpy")
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
            return python.waitFor() == 0;
        } catch (IOException e) {
            return false;
        }
    }

    private static List<String> python(int tapPort, JsonNode velocity, List<JsonNode> subscriptions)
            throws IOException {
        Process process = new ProcessBuilder(Stream.concat(
                                Stream.of(
                                        PYTHON,
                                        CLIENT.toString(),
                                        "127.0.0.1",
                                        String.valueOf(tapPort),
                                        velocity.path("topic").asText(),
                                        velocity.path("type").asText(),
                                        subscriptions.toString()),
                                Stream.of(
                                                RosDriver.SETTLING_MS,
                                                RosDriver.MEASURED_MS,
                                                RosDriver.DRIVING_MS,
                                                RosDriver.STANDING_MS,
                                                RosDriver.ROUNDS)
                                        .map(String::valueOf))
                        .toList())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        try (BufferedReader out = process.inputReader()) {
            return out.lines().toList();
        }
    }

    private static String figures(String name, List<String> lines, RosTap tap, long began) {
        double seconds = (System.nanoTime() - began) / (double) TimeUnit.SECONDS.toNanos(1);
        double[] drives = times(lines, "drive ", tap.velocities(), false);
        double[] stops = times(lines, "stop ", tap.velocities(), true);
        return row(
                name,
                format("%.2f %%", value(lines, "reporting ")),
                format("%.2f %%", value(lines, "driven ")),
                format("%.2f ms", share(drives, 0.5)),
                format("%.2f ms", share(drives, 0.99)),
                format("%.2f ms", share(stops, 0.5)),
                format("%.2f ms", share(stops, 0.99)),
                format("%.0f", tap.bytesToClients() / 1024.0 / seconds));
    }

    private static double value(List<String> lines, String key) {
        return lines.stream()
                .filter(line -> line.startsWith(key))
                .mapToDouble(line -> Double.parseDouble(line.substring(key.length())))
                .findFirst()
                .orElse(Double.NaN);
    }

    /**
     * Returns the times of the measured rounds, which are the last ones, from a command to the first velocity of its
     * kind, ms.
     */
    private static double[] times(List<String> lines, String key, List<RosTap.Velocity> velocities, boolean zero) {
        List<Long> commands = lines.stream()
                .filter(line -> line.startsWith(key))
                .map(line -> Long.parseLong(line.substring(key.length())))
                .toList();
        return commands.subList(Math.max(0, commands.size() - RosDriver.ROUNDS), commands.size()).stream()
                .flatMapToDouble(command -> {
                    OptionalLong arrival = velocities.stream()
                            .filter(velocity -> velocity.isZero() == zero && velocity.nanos() > command)
                            .mapToLong(RosTap.Velocity::nanos)
                            .findFirst();
                    return arrival.isPresent()
                            ? DoubleStream.of((arrival.getAsLong() - command) / 1e6)
                            : DoubleStream.of(Double.POSITIVE_INFINITY);
                })
                .sorted()
                .toArray();
    }

    private static double share(double[] sorted, double share) {
        return sorted.length == 0 ? Double.NaN : sorted[(int) Math.min(sorted.length - 1, sorted.length * share)];
    }

    private static String format(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }

    private static String row(String... cells) {
        StringBuilder row = new StringBuilder(String.format("%-9s", cells[0]));
        Arrays.stream(cells).skip(1).forEach(cell -> row.append(String.format("%15s", cell)));
        return row.toString();
    }
}
