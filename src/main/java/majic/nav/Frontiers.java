package majic.nav;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import majic.bot.Pose;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;

/**
 * Where the known part of a map ends: free cells next to unknown ones, in connected groups at least as long as a robot
 * is wide (Yamauchi 1997). Unknown cells close to a wall are left out: those inside of it, and those that beams along
 * it leave. Immutable.
 */
final class Frontiers {
    /** The cells around one, those that share a side with it first. */
    private static final int[] RIGHT = {1, 0, -1, 0, 1, -1, -1, 1};

    private static final int[] UP = {0, 1, 0, -1, 1, 1, -1, -1};
    private static final int SIDES = 4;

    /** Unknown cells as near to a wall are left out. */
    private static final int WALL_CELLS = 2;

    private final OccupancyGrid grid;
    private final BitSet cells = new BitSet();

    Frontiers(OccupancyGrid grid, double leastMm) {
        this.grid = grid;
        BitSet edge = new BitSet();
        for (int row = 0; row < grid.height(); row++) {
            for (int column = 0; column < grid.width(); column++) {
                if (isEdge(column, row)) {
                    edge.set(row * grid.width() + column);
                }
            }
        }
        for (int cell = edge.nextSetBit(0); cell >= 0; cell = edge.nextSetBit(cell)) {
            List<Integer> group = takeGroup(edge, cell);
            if (group.size() * grid.cellMm() >= leastMm) {
                group.forEach(cells::set);
            }
        }
    }

    private boolean isEdge(int column, int row) {
        if (grid.state(column, row) == State.FREE) {
            for (int side = 0; side < SIDES; side++) {
                if (isOpen(column + RIGHT[side], row + UP[side])) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean isOpen(int column, int row) {
        if (grid.state(column, row) != State.UNKNOWN) {
            return false;
        }
        for (int right = -WALL_CELLS; right <= WALL_CELLS; right++) {
            for (int up = -WALL_CELLS; up <= WALL_CELLS; up++) {
                if (grid.state(column + right, row + up) == State.OCCUPIED) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Removes a cell and all that are connected with it. */
    private List<Integer> takeGroup(BitSet edge, int first) {
        List<Integer> group = new ArrayList<>(List.of(first));
        edge.clear(first);
        for (int index = 0; index < group.size(); index++) {
            for (int next = 0; next < RIGHT.length; next++) {
                int cell = neighbour(group.get(index), next);
                if (cell >= 0 && edge.get(cell)) {
                    edge.clear(cell);
                    group.add(cell);
                }
            }
        }
        return group;
    }

    private int neighbour(int cell, int next) {
        int column = cell % grid.width() + RIGHT[next];
        int row = cell / grid.width() + UP[next];
        return column < 0 || row < 0 || column >= grid.width() || row >= grid.height()
                ? -1
                : row * grid.width() + column;
    }

    private Pose centre(int cell) {
        return grid.centre(cell % grid.width(), cell / grid.width());
    }

    /** Returns whether a frontier is as near to a place. */
    boolean isNear(Pose place, double mm) {
        return cells.stream().anyMatch(cell -> centre(cell).distanceMm(place) <= mm);
    }

    /** The places from which a frontier is near, without a wall between. */
    final class Views {
        private final int[] seen = new int[grid.width() * grid.height()];

        private Views(Predicate<Pose> wanted, double farthestMm) {
            Arrays.fill(seen, -1);
            ArrayDeque<Integer> ring = new ArrayDeque<>();
            cells.stream().filter(cell -> wanted.test(centre(cell))).forEach(cell -> {
                seen[cell] = cell;
                ring.add(cell);
            });
            for (double mm = grid.cellMm(); mm <= farthestMm; mm += grid.cellMm()) {
                for (int left = ring.size(); left > 0; left--) {
                    spread(ring.remove(), ring);
                }
            }
        }

        private void spread(int cell, ArrayDeque<Integer> ring) {
            for (int side = 0; side < SIDES; side++) {
                int next = neighbour(cell, side);
                if (next >= 0 && seen[next] < 0 && grid.state(next % grid.width(), next / grid.width()) == State.FREE) {
                    seen[next] = seen[cell];
                    ring.add(next);
                }
            }
        }

        /** Returns the place of the frontier that is near, with the direction to what is unknown. */
        Optional<Pose> from(Pose place) {
            Pose at = place.seenFrom(grid.origin());
            int column = (int) Math.floor(at.xMm() / grid.cellMm());
            int row = (int) Math.floor(at.yMm() / grid.cellMm());
            boolean inside = column >= 0 && row >= 0 && column < grid.width() && row < grid.height();
            int cell = inside ? seen[row * grid.width() + column] : -1;
            return cell < 0 ? Optional.empty() : Optional.of(outward(cell));
        }
    }

    private Pose outward(int cell) {
        int right = 0;
        int up = 0;
        for (int next = 0; next < RIGHT.length; next++) {
            if (isOpen(cell % grid.width() + RIGHT[next], cell / grid.width() + UP[next])) {
                right += RIGHT[next];
                up += UP[next];
            }
        }
        Pose centre = centre(cell);
        return new Pose(centre.xMm(), centre.yMm(), centre.headingDeg() + Math.toDegrees(Math.atan2(up, right)));
    }

    /**
     * Returns from where frontiers are seen.
     *
     * @param wanted which cells of frontiers count
     * @param farthestMm how far from a frontier a place may be, over free cells
     */
    Views views(Predicate<Pose> wanted, double farthestMm) {
        return new Views(wanted, farthestMm);
    }
}
