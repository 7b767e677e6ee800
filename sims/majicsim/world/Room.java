package majicsim.world;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * The fixed part of a lab: walls, start places, lamps, tape on the floor. Read from the vendor's map text (ARCOS sheet
 * appendix B). Immutable.
 */
public final class Room {
    private static final String STANDARD = "/worlds/lab.map";

    /** So many robots have space to drive in the standard room. */
    private static final int MOST_IN_STANDARD = 11;

    private static final double CELL_MM = 500;

    /** Suits areas as large as what a sonar measures. */
    private static final double COARSE_CELL_MM = 2500;

    private final List<Segment> walls;
    private final Shape[] wallShapes;
    private final double[] reflectivities;
    private final List<Point> corners;
    private final List<Pose> homes;
    private final List<Pose> landmarks;
    private final RoomContents contents;
    private final Bounds bounds;
    private final WallIndex index;
    private final WallIndex coarseIndex;
    private final WallIndex cornerIndex;

    Room(List<Segment> walls, List<Pose> homes, List<Pose> landmarks, RoomContents contents) {
        this.walls = List.copyOf(walls);
        this.wallShapes = walls.stream().map(Shape::of).toArray(Shape[]::new);
        this.reflectivities = walls.stream().mapToDouble(Segment::reflectivity).toArray();
        this.corners = corners(walls);
        this.homes = List.copyOf(homes);
        this.landmarks = List.copyOf(landmarks);
        this.contents = contents;
        this.bounds = Bounds.around(walls);
        this.index = new WallIndex(this.walls, bounds, CELL_MM);
        this.coarseIndex = new WallIndex(this.walls, bounds, COARSE_CELL_MM);
        this.cornerIndex = new WallIndex(corners.stream().map(Room::pointWall).toList(), bounds, COARSE_CELL_MM);
    }

    /**
     * Returns each end of a wall once. Keys that are lists find equal ones: the hash code of a record is linked at run
     * time, which would delay every start of the lab by some 10 ms.
     */
    private static List<Point> corners(List<Segment> walls) {
        Map<List<Double>, Point> corners = new LinkedHashMap<>();
        walls.stream()
                .flatMap(wall -> Stream.of(new Point(wall.x1(), wall.y1()), new Point(wall.x2(), wall.y2())))
                .forEach(end -> corners.putIfAbsent(List.of(end.xMm(), end.yMm()), end));
        return List.copyOf(corners.values());
    }

    /**
     * Reads a map file.
     *
     * @param file a map in the vendor's text format
     * @return the room
     * @throws IOException if it cannot be read or is no such map; the message names the file, the line and what is
     *     wrong
     */
    public static Room load(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw new IOException(file + " is a folder, not a map file");
        }
        try (Reader reader = Files.newBufferedReader(file, StandardCharsets.ISO_8859_1)) {
            return parse(reader, file.toString());
        } catch (NoSuchFileException e) {
            throw new IOException("there is no map file " + file, e);
        } catch (FileSystemException e) {
            throw new IOException("cannot read the map file " + file + ": " + e.getReason(), e);
        }
    }

    /**
     * Reads a map.
     *
     * @param text a map in the vendor's text format; not closed
     * @param name of the map, for messages
     * @return the room
     * @throws IOException if it cannot be read or is no such map; the message gives name, line and what is wrong
     */
    public static Room parse(Reader text, String name) throws IOException {
        return new MapParser(name, new BufferedReader(text)).parse();
    }

    /**
     * The room that ships with the program: about 9 x 7 m with a few boxes.
     *
     * @return the room
     */
    public static Room standard() {
        try (InputStream stream = Room.class.getResourceAsStream(STANDARD)) {
            if (stream == null) {
                throw new IllegalStateException("the program's own room " + STANDARD + " is missing from its jar");
            }
            return parse(new InputStreamReader(stream, StandardCharsets.UTF_8), "lab.map");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * A room with space for many robots: the one that ships with the program, or a larger hall if that has too little
     * space.
     *
     * @param robots how many, 1 or more
     * @return a room with a start place for each, at least 2 m from the next one in the hall
     */
    public static Room forRobots(int robots) {
        return robots <= MOST_IN_STANDARD ? standard() : Hall.of(robots);
    }

    /**
     * All walls, boxes as their four sides.
     *
     * @return an unchangeable list
     */
    public List<Segment> walls() {
        return walls;
    }

    /**
     * The rectangle around the walls.
     *
     * @return the bounds; 10 x 10 m around the origin if there is no wall
     */
    public Bounds bounds() {
        return bounds;
    }

    /**
     * Its lamps.
     *
     * @return an unchangeable list
     */
    public List<Lamp> lamps() {
        return contents.lamps();
    }

    /**
     * The black tape on its floor.
     *
     * @return an unchangeable list
     */
    public List<Tape> tapes() {
        return contents.tapes();
    }

    /**
     * Start places the map names, in its order.
     *
     * @return an unchangeable list, maybe empty
     */
    public List<Pose> homes() {
        return homes;
    }

    /**
     * A start place.
     *
     * @param n number of the robot, from 1
     * @return the map's n-th RobotHome, or where there are fewer, a free place of some room found near the first
     * @throws IllegalArgumentException if n is below 1, or the map has no room left for so many robots
     */
    public Pose home(int n) {
        if (n < 1) {
            throw new IllegalArgumentException("robots are numbered from 1, not " + n);
        }
        return homes(n).get(n - 1);
    }

    /**
     * The start places of the first robots, which are found together because a search for each alone would repeat the
     * others'.
     *
     * @param count how many robots
     * @return so many places, as {@link #home} returns them
     * @throws IllegalArgumentException if the map has no room left for so many robots
     */
    public List<Pose> homes(int count) {
        return new StartPlaces(this).places(count);
    }

    private static Segment pointWall(Point at) {
        return new Segment(at.xMm(), at.yMm(), at.xMm(), at.yMm(), 0);
    }

    /** Goals and docks: places that are surely inside. */
    List<Pose> landmarks() {
        return landmarks;
    }

    Shape wallShape(int number) {
        return wallShapes[number];
    }

    double reflectivity(int wall) {
        return reflectivities[wall];
    }

    /**
     * All walls that a ray in the cone may meet; also some that none does.
     *
     * @param around the bounds of the cone
     */
    WallsInCone wallsIn(Cone cone, Bounds around) {
        WallsInCone found = new WallsInCone(cone, walls);
        coarseIndex.near(around.minX(), around.minY(), around.maxX(), around.maxY(), found);
        return found;
    }

    Segment wall(int number) {
        return walls.get(number);
    }

    /** Passes on all ends of walls within this distance; also some that are farther. */
    void cornersNear(double xMm, double yMm, double withinMm, Consumer<Point> visitor) {
        cornerIndex.near(
                xMm - withinMm,
                yMm - withinMm,
                xMm + withinMm,
                yMm + withinMm,
                number -> visitor.accept(corners.get(number)));
    }

    WallIndex index() {
        return index;
    }
}
