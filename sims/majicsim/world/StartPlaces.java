package majicsim.world;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Finds start places if a map names too few: from a place inside the room the search spreads over the floor, never through a wall,
 * until the strip ahead and behind is free of walls and of the other robots' strips.
 */
final class StartPlaces {
    private static final double GRID_MM = 400;
    private static final double HALF_WIDTH_MM = 320;
    private static final double[] LANES_MM = {1850, 1200, 700, 400};
    private static final double[] HEADINGS_DEG = {0, 90};

    private final Room room;
    private final List<Pose> places;
    private final List<Shape> taken = new ArrayList<>();

    StartPlaces(Room room) {
        this.room = room;
        this.places = new ArrayList<>(room.homes());
        places.forEach(home -> taken.add(lane(LANES_MM[0]).at(home)));
    }

    Pose place(int n) {
        if (n < 1) {
            throw new IllegalArgumentException("robots are numbered from 1, not " + n);
        }
        while (places.size() < n) {
            Pose found = next();
            places.add(found);
            taken.add(lane(LANES_MM[0]).at(found));
        }
        return places.get(n - 1);
    }

    private Pose next() {
        for (double laneMm : LANES_MM) {
            for (Pose seed : seeds()) {
                Optional<Pose> found = search(seed, lane(laneMm));
                if (found.isPresent()) {
                    return found.get();
                }
            }
        }
        throw new IllegalArgumentException("the map has no free place left for robot " + (places.size() + 1));
    }

    private List<Pose> seeds() {
        List<Pose> seeds = new ArrayList<>(room.homes());
        seeds.addAll(room.landmarks());
        if (seeds.isEmpty()) {
            Bounds b = room.bounds();
            seeds.add(new Pose((b.minX() + b.maxX()) / 2, (b.minY() + b.maxY()) / 2, 0));
        }
        return seeds;
    }

    private Optional<Pose> search(Pose seed, Shape lane) {
        ArrayDeque<Cell> open = new ArrayDeque<>(List.of(new Cell(0, 0)));
        Set<Cell> seen = new HashSet<>(open);
        while (!open.isEmpty()) {
            Cell cell = open.remove();
            for (double heading : HEADINGS_DEG) {
                Pose pose = cell.from(seed, heading);
                if (isFree(lane.at(pose))) {
                    return Optional.of(pose);
                }
            }
            for (Cell neighbour : cell.neighbours()) {
                if (isOpen(seed, cell, neighbour) && seen.add(neighbour)) {
                    open.add(neighbour);
                }
            }
        }
        return Optional.empty();
    }

    private boolean isFree(Shape lane) {
        return taken.stream().allMatch(other -> Gap.between(lane, other).mm() > 0) && meetsNoWall(lane);
    }

    private boolean isOpen(Pose seed, Cell from, Cell to) {
        Pose a = from.from(seed, 0);
        Pose b = to.from(seed, 0);
        return room.bounds().contains(b.xMm(), b.yMm())
                && meetsNoWall(Shape.of(new Segment(a.xMm(), a.yMm(), b.xMm(), b.yMm(), 1)));
    }

    private boolean meetsNoWall(Shape shape) {
        for (int i = 0; i < room.walls().size(); i++) {
            if (Gap.between(shape, room.wallShape(i)).mm() <= 0) {
                return false;
            }
        }
        return true;
    }

    private static Shape lane(double halfLengthMm) {
        double[] xs = {halfLengthMm, halfLengthMm, -halfLengthMm, -halfLengthMm};
        double[] ys = {-HALF_WIDTH_MM, HALF_WIDTH_MM, HALF_WIDTH_MM, -HALF_WIDTH_MM};
        return new Shape(xs, ys, 0);
    }

    private record Cell(int column, int row) {
        Pose from(Pose seed, double headingDeg) {
            return new Pose(seed.xMm() + column * GRID_MM, seed.yMm() + row * GRID_MM, headingDeg);
        }

        List<Cell> neighbours() {
            return List.of(
                    new Cell(column + 1, row),
                    new Cell(column - 1, row),
                    new Cell(column, row + 1),
                    new Cell(column, row - 1));
        }
    }
}
