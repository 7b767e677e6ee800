package majic.gui.drive;

import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.Set;

/** A direction of manual driving; two at once make a curve. */
enum Direction {
    AHEAD(1, 0),
    BACK(-1, 0),
    LEFT(0, 1),
    RIGHT(0, -1);

    private final int forward;
    private final int left;

    Direction(int forward, int left) {
        this.forward = forward;
        this.left = left;
    }

    /** Returns the direction of an arrow key, on the numeric keypad too. */
    static Optional<Direction> of(int keyCode) {
        return switch (keyCode) {
            case KeyEvent.VK_UP, KeyEvent.VK_KP_UP -> Optional.of(AHEAD);
            case KeyEvent.VK_DOWN, KeyEvent.VK_KP_DOWN -> Optional.of(BACK);
            case KeyEvent.VK_LEFT, KeyEvent.VK_KP_LEFT -> Optional.of(LEFT);
            case KeyEvent.VK_RIGHT, KeyEvent.VK_KP_RIGHT -> Optional.of(RIGHT);
            default -> Optional.empty();
        };
    }

    /** Returns the forward part of all these directions: −1, 0 or 1. */
    static int forward(Set<Direction> all) {
        return all.stream().mapToInt(direction -> direction.forward).sum();
    }

    /** Returns the leftward part of all these directions: −1, 0 or 1. */
    static int left(Set<Direction> all) {
        return all.stream().mapToInt(direction -> direction.left).sum();
    }
}
