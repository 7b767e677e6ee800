package majic.nav.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.Pose;
import majic.nav.grid.GridBuilder;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.NavigationMap.ForbiddenLine;
import majic.nav.grid.NavigationMap.Place;
import majic.nav.grid.OccupancyGrid;

/**
 * The maps of the Pioneer world, {@code .map}: lines and points in mm, goals, home, forbidden lines and areas (ARIA's
 * class ArMap). Lines and points are drawn into a grid of 50 mm; all else between them is free, since these maps do not
 * state what was never seen. A forbidden area is read as its four sides. Other lines are skipped, such as
 * {@code MapInfo}.
 *
 * <p>At most {@value #MOST_LINES} lines; the map is at most as large as a grid can be.
 */
final class PioneerWorldFile {
    static final int MOST_LINES = 5_000_000;

    /** The greatest coordinate, mm. */
    private static final double FAR_MM = 1e7;

    /** Cells around what is drawn. */
    private static final int MARGIN = 2;

    /** Word, x, y, heading, and the rest behind the description and the icon: name and coordinates. */
    private static final Pattern CAIRN =
            Pattern.compile("Cairn: (\\S+) (\\S+) (\\S+) (\\S+) \"[^\"]*\" ICON \"([^\"]*)\"(.*)");

    private final NumberedLines lines;
    private final List<double[]> segments = new ArrayList<>();
    private final List<Place> places = new ArrayList<>();
    private final List<ForbiddenLine> forbidden = new ArrayList<>();
    private Optional<Pose> home = Optional.empty();

    private PioneerWorldFile(NumberedLines lines) {
        this.lines = lines;
    }

    static NavigationMap read(Path file) throws IOException {
        try (NumberedLines lines = NumberedLines.open(file, MOST_LINES)) {
            return new PioneerWorldFile(lines).read();
        }
    }

    private NavigationMap read() throws IOException {
        String first = lines.next();
        if (first == null || !first.strip().startsWith("2D-Map")) {
            throw lines.wrong("a map of the Pioneer world begins with 2D-Map");
        }
        int coordinates = 0;
        for (String line = lines.next(); line != null; line = lines.next()) {
            String text = line.strip();
            if (text.startsWith("Cairn:")) {
                cairn(text);
            } else if (text.equals("LINES")) {
                coordinates = 4;
            } else if (text.equals("DATA")) {
                coordinates = 2;
            } else if (coordinates > 0 && !text.isEmpty()) {
                double[] read = coordinates(text, coordinates);
                segments.add(read.length == 4 ? read : new double[] {read[0], read[1], read[0], read[1]});
            }
        }
        if (segments.isEmpty()) {
            throw lines.wrong("the map has no lines and no points; LINES or DATA has to be followed by some");
        }
        return new NavigationMap(drawn(), places, forbidden, home);
    }

    private double[] coordinates(String text, int count) throws IOException {
        String[] fields = text.split("\\s+");
        if (fields.length != count) {
            throw lines.wrong("'" + NumberedLines.shortened(text) + "' is not " + count + " numbers in mm");
        }
        double[] read = new double[count];
        for (int index = 0; index < count; index++) {
            read[index] = lines.number(fields[index], "a coordinate (mm)", -FAR_MM, FAR_MM);
        }
        return read;
    }

    private void cairn(String text) throws IOException {
        Matcher matcher = CAIRN.matcher(text);
        if (!matcher.matches()) {
            throw lines.wrong("a Cairn has a kind, x, y, heading, \"\", ICON and a name in quotation marks");
        }
        Pose pose = new Pose(
                lines.number(matcher.group(2), "x (mm)", -FAR_MM, FAR_MM),
                lines.number(matcher.group(3), "y (mm)", -FAR_MM, FAR_MM),
                lines.number(matcher.group(4), "the heading (deg)", -FAR_MM, FAR_MM));
        String name = matcher.group(5);
        String rest = matcher.group(6).strip();
        switch (matcher.group(1)) {
            case "Goal" -> place(name, pose, false);
            case "GoalWithHeading" -> place(name, pose, true);
            case "RobotHome" -> home = Optional.of(pose);
            case "ForbiddenLine" -> {
                double[] ends = coordinates(rest, 4);
                forbidden.add(new ForbiddenLine(ends[0], ends[1], ends[2], ends[3]));
            }
            case "ForbiddenArea" -> forbid(coordinates(rest, 4), pose.headingDeg());
            default -> {
                // Docks and objects for the simulator.
            }
        }
    }

    private void place(String name, Pose pose, boolean withHeading) {
        if (!name.isBlank()) {
            places.add(new Place(name, pose, withHeading));
        }
    }

    /** The sides of an area, whose corners are given in a frame that is turned about the origin. */
    private void forbid(double[] corners, double headingDeg) {
        Pose frame = new Pose(0, 0, headingDeg);
        double[][] around = {
            {corners[0], corners[1]}, {corners[2], corners[1]}, {corners[2], corners[3]}, {corners[0], corners[3]}
        };
        for (int side = 0; side < around.length; side++) {
            Pose from = frame.plus(new Pose(around[side][0], around[side][1], 0));
            double[] end = around[(side + 1) % around.length];
            Pose to = frame.plus(new Pose(end[0], end[1], 0));
            forbidden.add(new ForbiddenLine(from.xMm(), from.yMm(), to.xMm(), to.yMm()));
        }
    }

    private OccupancyGrid drawn() throws IOException {
        double cell = GridBuilder.CELL_MM;
        double minX = Double.MAX_VALUE;
        double minY = Double.MAX_VALUE;
        double maxX = -Double.MAX_VALUE;
        double maxY = -Double.MAX_VALUE;
        for (double[] segment : segments) {
            minX = Math.min(minX, Math.min(segment[0], segment[2]));
            minY = Math.min(minY, Math.min(segment[1], segment[3]));
            maxX = Math.max(maxX, Math.max(segment[0], segment[2]));
            maxY = Math.max(maxY, Math.max(segment[1], segment[3]));
        }
        // Drawn rooms have their walls at multiples of a cell, which are in the middle of cells so.
        double left = (Math.floor(minX / cell) - MARGIN - 0.5) * cell;
        double low = (Math.floor(minY / cell) - MARGIN - 0.5) * cell;
        long width = (long) ((maxX - left) / cell) + 1 + MARGIN;
        long height = (long) ((maxY - low) / cell) + 1 + MARGIN;
        if (width * height > OccupancyGrid.MOST_CELLS) {
            throw lines.wrong("the map is " + Math.round((maxX - minX) / 1000) + " m by "
                    + Math.round((maxY - minY) / 1000) + " m; up to 400 m by 400 m can be read");
        }
        boolean[] occupied = new boolean[(int) (width * height)];
        for (double[] segment : segments) {
            double length = Math.hypot(segment[2] - segment[0], segment[3] - segment[1]);
            int steps = (int) Math.ceil(2 * length / cell);
            for (int step = 0; step <= steps; step++) {
                double share = steps == 0 ? 0 : (double) step / steps;
                int x = (int) ((segment[0] + share * (segment[2] - segment[0]) - left) / cell);
                int y = (int) ((segment[1] + share * (segment[3] - segment[1]) - low) / cell);
                occupied[(int) (y * width + x)] = true;
            }
        }
        return OccupancyGrid.of(
                new Pose(left, low, 0),
                cell,
                (int) width,
                (int) height,
                (column, row) -> occupied[(int) (row * width + column)] ? 1 : 0);
    }
}
