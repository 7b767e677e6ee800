package majic.panel.map;

import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import majic.bot.Pose;

/**
 * Holds the path of a robot from its first pose on, in bounded memory: when it is full, every other point is removed,
 * so that old and long paths get coarser but none gets shorter. Thread-safe; no call blocks for long.
 */
public final class Trail {
    private static final int CAPACITY = 2048;
    private static final double FIRST_STEP_MM = 20;

    /** Distance in mm between two reports that no robot can cover: its pose was set anew. */
    private static final double JUMP_MM = 1000;

    private final float[] xs = new float[CAPACITY];
    private final float[] ys = new float[CAPACITY];
    private final boolean[] jumps = new boolean[CAPACITY];
    private int size;
    private double stepMm = FIRST_STEP_MM;

    /**
     * Adds the robot's pose; one less than a step from the last point is left out.
     *
     * @param pose now
     */
    public synchronized void add(Pose pose) {
        double path =
                size == 0 ? Double.POSITIVE_INFINITY : Math.hypot(pose.xMm() - xs[size - 1], pose.yMm() - ys[size - 1]);
        if (path < stepMm) {
            return;
        }
        if (size == CAPACITY) {
            thin();
        }
        xs[size] = (float) pose.xMm();
        ys[size] = (float) pose.yMm();
        jumps[size] = path > JUMP_MM + stepMm;
        size++;
    }

    /** Removes every other point; a jump to a removed point becomes a jump to the next one. */
    private void thin() {
        int kept = 0;
        for (int index = 0; index < size; index += 2) {
            xs[kept] = xs[index];
            ys[kept] = ys[index];
            jumps[kept] = jumps[index] || index > 0 && jumps[index - 1];
            kept++;
        }
        size = kept;
        stepMm *= 2;
    }

    /** Removes all points. */
    public synchronized void clear() {
        size = 0;
        stepMm = FIRST_STEP_MM;
    }

    /**
     * Copies the trail into a path.
     *
     * @param path cleared first, then filled with the trail on the floor, mm
     * @param leastMm points closer than this to the one before are left out
     */
    public synchronized void trace(Path2D path, double leastMm) {
        path.reset();
        double lastX = 0;
        double lastY = 0;
        for (int index = 0; index < size; index++) {
            if (jumps[index]) {
                path.moveTo(xs[index], ys[index]);
            } else if (index < size - 1 && Math.hypot(xs[index] - lastX, ys[index] - lastY) < leastMm) {
                continue;
            } else {
                path.lineTo(xs[index], ys[index]);
            }
            lastX = xs[index];
            lastY = ys[index];
        }
    }

    /**
     * Enlarges an area of the floor so that it contains the trail.
     *
     * @param extent mm; grows
     */
    public synchronized void extend(Rectangle2D extent) {
        for (int index = 0; index < size; index++) {
            extent.add(xs[index], ys[index]);
        }
    }
}
