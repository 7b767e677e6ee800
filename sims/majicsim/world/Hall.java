package majicsim.world;

import java.util.ArrayList;
import java.util.List;

/**
 * Makes a hall with a place for each of many robots: squares of the same size in rows, one start place in the middle of
 * each, and a pillar at every second corner of the squares, so that sensors measure something everywhere.
 */
final class Hall {
    private static final double SQUARE_MM = 2500;
    private static final double HALF_PILLAR_MM = 150;
    private static final double WHITE = 1;

    /** The robot that can follow tape and find lamps. */
    private static final int HEMISSON = 3;

    private static final double TAPE_AHEAD_MM = 400;
    private static final double TAPE_LENGTH_MM = 600;

    private final int columns;
    private final int rows;
    private final List<Segment> walls = new ArrayList<>();

    private Hall(int robots) {
        columns = (int) Math.ceil(Math.sqrt(robots));
        rows = (robots + columns - 1) / columns;
    }

    static Room of(int robots) {
        return new Hall(robots).room(robots);
    }

    private Room room(int robots) {
        box(0, 0, columns * SQUARE_MM, rows * SQUARE_MM);
        for (int row = 1; row < rows; row += 2) {
            for (int column = 1; column < columns; column += 2) {
                pillar(column * SQUARE_MM, row * SQUARE_MM);
            }
        }
        List<Pose> homes = new ArrayList<>();
        for (int number = 1; number <= robots; number++) {
            homes.add(home(number));
        }
        return new Room(walls, homes, List.of(), contents());
    }

    private Pose home(int number) {
        int square = number - 1;
        return new Pose((square % columns + 0.5) * SQUARE_MM, (rows - square / columns - 0.5) * SQUARE_MM, 0);
    }

    private RoomContents contents() {
        Pose home = home(HEMISSON);
        Tape tape = new Tape(List.of(home.toWorld(TAPE_AHEAD_MM, 0), home.toWorld(TAPE_AHEAD_MM + TAPE_LENGTH_MM, 0)));
        Lamp lamp = new Lamp(home.toWorld(0, SQUARE_MM / 4));
        return new RoomContents(List.of(lamp), List.of(tape));
    }

    private void pillar(double x, double y) {
        box(x - HALF_PILLAR_MM, y - HALF_PILLAR_MM, x + HALF_PILLAR_MM, y + HALF_PILLAR_MM);
    }

    private void box(double minX, double minY, double maxX, double maxY) {
        walls.add(new Segment(minX, minY, maxX, minY, WHITE));
        walls.add(new Segment(maxX, minY, maxX, maxY, WHITE));
        walls.add(new Segment(maxX, maxY, minX, maxY, WHITE));
        walls.add(new Segment(minX, maxY, minX, minY, WHITE));
    }
}
