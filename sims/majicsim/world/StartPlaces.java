package majicsim.world;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Finds start places if a map names too few: from a place inside the room the search spreads over the floor, never
 * through a wall, until the strip ahead and behind is free of walls and of the other robots' strips. A search goes on
 * where it found the last place, since no place becomes free again.
 */
final class StartPlaces {
    private static final double GRID_MM = 400;
    private static final double HALF_WIDTH_MM = 320;
    private static final double[] LANES_MM = {1850, 1200, 700, 400};
    private static final double[] HEADINGS_DEG = {0, 90};

    private final Room room;
    private final List<Pose> places;
    private final List<Shape> taken = new ArrayList<>();
    private final List<Search> searches = new ArrayList<>();

    StartPlaces(Room room) {
        this.room = room;
        this.places = new ArrayList<>(room.homes());
        places.forEach(home -> taken.add(lane(LANES_MM[0]).at(home)));
        for (double laneMm : LANES_MM) {
            seeds().forEach(seed -> searches.add(new Search(seed, laneMm)));
        }
    }

    List<Pose> places(int count) {
        while (places.size() < count) {
            Pose found = next();
            places.add(found);
            taken.add(lane(LANES_MM[0]).at(found));
        }
        return List.copyOf(places.subList(0, count));
    }

    private Pose next() {
        for (Search search : searches) {
            Pose found = search.next();
            if (found != null) {
                return found;
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

    private static Shape lane(double halfLengthMm) {
        double[] xs = {halfLengthMm, halfLengthMm, -halfLengthMm, -halfLengthMm};
        double[] ys = {-HALF_WIDTH_MM, HALF_WIDTH_MM, HALF_WIDTH_MM, -HALF_WIDTH_MM};
        return new Shape(xs, ys, 0);
    }

    /** The search for strips of one length from one place. */
    private final class Search {
        private final Pose seed;
        private final Shape lane;
        private final double apartMm;
        private final ArrayDeque<Cell> open = new ArrayDeque<>(List.of(new Cell(0, 0)));
        private final Set<Cell> seen = new HashSet<>(open);

        Search(Pose seed, double laneMm) {
            this.seed = seed;
            this.lane = lane(laneMm);
            this.apartMm = lane.reachMm() + lane(LANES_MM[0]).reachMm();
        }

        /** The next free place; null if there is none. */
        @Nullable
        Pose next() {
            while (!open.isEmpty()) {
                Pose found = freeIn(open.element());
                if (found != null) {
                    return found;
                }
                spreadFrom(open.remove());
            }
            return null;
        }

        private @Nullable Pose freeIn(Cell cell) {
            for (double heading : HEADINGS_DEG) {
                Pose pose = cell.from(seed, heading);
                if (isFree(pose)) {
                    return pose;
                }
            }
            return null;
        }

        private void spreadFrom(Cell cell) {
            for (Cell neighbour : cell.neighbours()) {
                if (isOpen(cell, neighbour) && seen.add(neighbour)) {
                    open.add(neighbour);
                }
            }
        }

        private boolean isFree(Pose pose) {
            Shape strip = lane.at(pose);
            for (int i = 0; i < taken.size(); i++) {
                boolean near = places.get(i).distanceTo(pose) <= apartMm;
                if (near && Gap.between(strip, taken.get(i)).mm() <= 0) {
                    return false;
                }
            }
            return meetsNoWall(strip, pose, lane.reachMm());
        }

        private boolean isOpen(Cell from, Cell to) {
            Pose a = from.from(seed, 0);
            Pose b = to.from(seed, 0);
            return room.bounds().contains(b.xMm(), b.yMm())
                    && meetsNoWall(Shape.of(new Segment(a.xMm(), a.yMm(), b.xMm(), b.yMm(), 1)), a, GRID_MM);
        }

        private boolean meetsNoWall(Shape shape, Pose at, double reachMm) {
            boolean[] free = {true};
            room.index().near(at.xMm() - reachMm, at.yMm() - reachMm, at.xMm() + reachMm, at.yMm() + reachMm, wall -> {
                free[0] &= Gap.between(shape, room.wallShape(wall)).mm() > 0;
            });
            return free[0];
        }
    }

    private record Cell(int column, int row) {
        Pose from(Pose seed, double headingDeg) {
            return new Pose(seed.xMm() + column * GRID_MM, seed.yMm() + row * GRID_MM, headingDeg);
        }

        /** Computed here, because that of a record is linked at run time, which would delay every start of the lab. */
        @Override
        public int hashCode() {
            return 31 * column + row;
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
