package majicsim.world;

import java.io.BufferedReader;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Reads the vendor's map text (ARCOS sheet appendix B): header lines in any order, then LINES, then DATA, where it
 * stops. Of the cairns it takes RobotHome, Sim.BoxObstacle (four walls), our own Lamp and Tape, and Goal and Dock as
 * places inside the room; unknown header lines are skipped. Scanned points are not walls.
 */
final class MapParser {
    private static final double WHITE = 1;
    private static final double FARTHEST_MM = 1_000_000;
    private static final int UNKNOWN = -1;

    private final String name;
    private final BufferedReader text;
    private final List<Segment> walls = new ArrayList<>();
    private final List<Segment> boxes = new ArrayList<>();
    private final List<Pose> homes = new ArrayList<>();
    private final List<Pose> landmarks = new ArrayList<>();
    private final List<Lamp> lamps = new ArrayList<>();
    private final List<Tape> tapes = new ArrayList<>();
    private int lineNumber;
    private int announcedLines = UNKNOWN;

    MapParser(String name, BufferedReader text) {
        this.name = name;
        this.text = text;
    }

    Room parse() throws IOException {
        String first = next();
        if (!"2D-Map".equals(first)) {
            throw error("a map begins with the line 2D-Map, not with " + quoted(first));
        }
        header();
        lines();
        if (announcedLines != UNKNOWN && announcedLines != walls.size()) {
            throw error("NumLines promises " + announcedLines + " lines, but " + walls.size() + " follow LINES");
        }
        walls.addAll(boxes);
        return new Room(walls, homes, landmarks, new RoomContents(lamps, tapes));
    }

    private void header() throws IOException {
        for (String line = next(); !"LINES".equals(line); line = next()) {
            if (line == null) {
                throw error("the map ends without its LINES");
            }
            if (line.startsWith("Cairn:")) {
                cairn(line.substring("Cairn:".length()).trim().split("\\s+"));
            } else if (line.startsWith("NumLines:")) {
                announcedLines = count(line.substring("NumLines:".length()).trim());
            }
        }
    }

    private void cairn(String[] words) throws IOException {
        switch (words[0]) {
            case "RobotHome" -> homes.add(pose(words));
            case "Goal", "GoalWithHeading", "Dock" -> landmarks.add(pose(words));
            case "Lamp" -> lamps.add(new Lamp(new Point(number(words, 1, "x"), number(words, 2, "y"))));
            case "Tape" -> tapes.add(tape(words));
            case "Sim.BoxObstacle" -> box(words);
            default -> {
                // Forbidden areas and the like do not concern a simulated robot.
            }
        }
    }

    private Pose pose(String[] words) throws IOException {
        return new Pose(number(words, 1, "x"), number(words, 2, "y"), number(words, 3, "heading"));
    }

    /** A rectangle whose corners are given in a frame turned by the cairn's heading. */
    private void box(String[] words) throws IOException {
        Pose frame = new Pose(0, 0, number(words, 3, "heading"));
        double x1 = number(words, words.length - 4, "x1");
        double y1 = number(words, words.length - 3, "y1");
        double x2 = number(words, words.length - 2, "x2");
        double y2 = number(words, words.length - 1, "y2");
        Point[] corners = {frame.toWorld(x1, y1), frame.toWorld(x2, y1), frame.toWorld(x2, y2), frame.toWorld(x1, y2)};
        for (int i = 0; i < corners.length; i++) {
            Point a = corners[i];
            Point b = corners[(i + 1) % corners.length];
            boxes.add(new Segment(a.xMm(), a.yMm(), b.xMm(), b.yMm(), WHITE));
        }
    }

    /** Two or more points follow the name, in a frame turned by the cairn's heading. */
    private Tape tape(String[] words) throws IOException {
        Pose frame = new Pose(0, 0, number(words, 3, "heading"));
        int first = words.length;
        while (first > 0 && !words[first - 1].endsWith("\"")) {
            first--;
        }
        if (first == 0 || words.length - first < 4) {
            throw error("a tape needs two points or more: x1 y1 x2 y2 ... after its name in quotes");
        }
        List<Point> points = new ArrayList<>();
        for (int i = first; i < words.length; i += 2) {
            points.add(frame.toWorld(number(words, i, "x"), number(words, i + 1, "y")));
        }
        return new Tape(points);
    }

    private void lines() throws IOException {
        for (String line = next(); line != null && !"DATA".equals(line); line = next()) {
            if (line.isEmpty()) {
                continue;
            }
            String[] words = line.split("\\s+");
            if (words.length != 4) {
                throw error("a line needs four numbers x1 y1 x2 y2, not " + quoted(line));
            }
            walls.add(new Segment(
                    number(words, 0, "x1"),
                    number(words, 1, "y1"),
                    number(words, 2, "x2"),
                    number(words, 3, "y2"),
                    WHITE));
        }
    }

    private double number(String[] words, int at, String what) throws IOException {
        if (at < 0 || at >= words.length) {
            throw error(what + " is missing");
        }
        try {
            double value = Double.parseDouble(words[at]);
            if (Math.abs(value) <= FARTHEST_MM) {
                return value;
            }
        } catch (NumberFormatException e) {
            throw error(what + " must be a number, not " + quoted(words[at]));
        }
        throw error(what + " must lie within 1 km of the origin, not " + quoted(words[at]));
    }

    private int count(String word) throws IOException {
        try {
            return Integer.parseUnsignedInt(word);
        } catch (NumberFormatException e) {
            throw error("NumLines must be a whole number, not " + quoted(word));
        }
    }

    private @Nullable String next() throws IOException {
        String line = text.readLine();
        lineNumber++;
        return line == null ? null : line.trim();
    }

    private IOException error(String what) {
        return new IOException(name + ":" + lineNumber + ": " + what);
    }

    private static String quoted(@Nullable String found) {
        if (found == null) {
            return "an empty file";
        }
        String visible = found.replaceAll("\\p{Cc}", "?");
        return "'" + (visible.length() > 40 ? visible.substring(0, 40) + "..." : visible) + "'";
    }
}
