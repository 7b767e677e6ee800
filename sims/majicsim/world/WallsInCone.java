package majicsim.world;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntConsumer;

/**
 * Collects the numbers of the walls that a ray in a cone may meet, each once. A class rather than a lambda expression,
 * because this runs some thousand times a second, and the quick compiler makes each lambda object by a call of the
 * virtual machine.
 */
final class WallsInCone implements IntConsumer {
    private static final int USUAL = 8;

    private final Cone cone;
    private final List<Segment> walls;
    private int[] found = new int[USUAL];
    private int count;

    WallsInCone(Cone cone, List<Segment> walls) {
        this.cone = cone;
        this.walls = walls;
    }

    /** Adds a wall of this number, unless no ray in the cone meets it. */
    @Override
    public void accept(int wall) {
        if (cone.mayMeet(walls.get(wall)) && !has(wall)) {
            if (count == found.length) {
                found = Arrays.copyOf(found, 2 * count);
            }
            found[count++] = wall;
        }
    }

    int count() {
        return count;
    }

    int get(int index) {
        return found[index];
    }

    private boolean has(int wall) {
        for (int i = 0; i < count; i++) {
            if (found[i] == wall) {
                return true;
            }
        }
        return false;
    }
}
