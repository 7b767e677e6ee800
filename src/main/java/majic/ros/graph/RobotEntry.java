package majic.ros.graph;

import java.util.ArrayList;
import java.util.List;

/** One entry of the table of robots while it is read. Used by one thread. */
final class RobotEntry {
    /** From rest to the highest speed where the acceleration is not known, seconds. */
    private static final double RAMP_S = 0.8;

    /** Of all limits, in their units. */
    private static final double LEAST = 0.001;

    private static final double MOST = 1_000_000;

    private final String name;
    private final List<RobotSign> signs = new ArrayList<>();
    private double radiusMm = 200;
    private double speedMmPerSec = 300;
    private double turnDegPerSec = 60;
    private double accelerationMmPerSec2 = Double.NaN;
    private double accelerationDegPerSec2 = Double.NaN;
    private double slowestMmPerSec = 12;
    private double slowestDegPerSec = 3;
    private double timeoutS = Double.NaN;
    private List<String> commands = List.of();
    private List<String> odometry = List.of();
    private String note = "";

    RobotEntry(String name) {
        this.name = name;
    }

    /** Copies the properties, but not the signs. */
    void like(KnownRobot other) {
        radiusMm = other.radiusMm();
        speedMmPerSec = other.speedMmPerSec();
        turnDegPerSec = other.turnDegPerSec();
        accelerationMmPerSec2 = other.accelerationMmPerSec2();
        accelerationDegPerSec2 = other.accelerationDegPerSec2();
        slowestMmPerSec = other.slowestMmPerSec();
        slowestDegPerSec = other.slowestDegPerSec();
        timeoutS = other.timeoutS();
        commands = other.commands();
        odometry = other.odometry();
        note = other.note();
    }

    /**
     * Takes in a property.
     *
     * @param key the first word of its line
     * @param words the others
     * @throws IllegalArgumentException if it is wrong; the message says what would be right
     */
    void set(String key, List<String> words) {
        switch (key) {
            case "when" -> signs.add(RobotSign.parse(words));
            case "radius" -> radiusMm = number(words, 0);
            case "speed" -> speedMmPerSec = number(words, 0);
            case "turn" -> turnDegPerSec = number(words, 0);
            case "acceleration" -> {
                accelerationMmPerSec2 = number(words, 0);
                accelerationDegPerSec2 = number(words, 1);
            }
            case "slowest" -> {
                slowestMmPerSec = number(words, 0);
                slowestDegPerSec = number(words, 1);
            }
            case "timeout" -> timeoutS = timeout(words);
            case "command" -> commands = List.copyOf(words);
            case "odometry" -> odometry = List.copyOf(words);
            case "note" -> note = String.join(" ", words);
            default ->
                throw new IllegalArgumentException(
                        "\"" + key + "\" is no property; there are when, like, radius, speed,"
                                + " turn, acceleration, slowest, timeout, command, odometry and note");
        }
    }

    private static double timeout(List<String> words) {
        String word = words.isEmpty() ? "" : words.get(0);
        return switch (word) {
            case "none" -> Double.POSITIVE_INFINITY;
            case "unknown" -> Double.NaN;
            default -> number(words, 0);
        };
    }

    private static double number(List<String> words, int index) {
        try {
            double number = Double.parseDouble(words.get(index));
            if (number >= LEAST && number <= MOST) {
                return number;
            }
        } catch (NumberFormatException | IndexOutOfBoundsException e) {
            throw new IllegalArgumentException("a number from 0.001 to 1000000 is missing", e);
        }
        throw new IllegalArgumentException(words.get(index) + " is not a number from 0.001 to 1000000");
    }

    List<RobotSign> signs() {
        return List.copyOf(signs);
    }

    KnownRobot robot() {
        return new KnownRobot(
                name,
                radiusMm,
                speedMmPerSec,
                turnDegPerSec,
                Double.isNaN(accelerationMmPerSec2) ? speedMmPerSec / RAMP_S : accelerationMmPerSec2,
                Double.isNaN(accelerationDegPerSec2) ? turnDegPerSec / RAMP_S : accelerationDegPerSec2,
                Math.min(slowestMmPerSec, speedMmPerSec),
                Math.min(slowestDegPerSec, turnDegPerSec),
                timeoutS,
                commands,
                odometry,
                note);
    }
}
