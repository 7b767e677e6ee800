package majicsim.world;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/**
 * A rigid robot: an outline around its turning centre, and its commanded velocity. The world moves it, never through a
 * wall or another body. Guarded by the lab's lock.
 */
public final class Body {
    /** Painted metal and plastic: a little darker than white paper. */
    static final double REFLECTIVITY = 0.8;

    private static final int DISC_DRAWN_WITH_CORNERS = 24;

    private final String name;
    private final Shape outline;
    private final double reachMm;
    private Predicate<Pose> fits = at -> true;
    private Consumer<Pose> movement = from -> {};
    private Runnable departure = () -> {};
    private Pose pose;
    private @Nullable Shape shape;
    private @Nullable List<Point> corners;
    private double wantedMmPerSec;
    private double wantedDegPerSec;
    private double speedMmPerSec;
    private double turnDegPerSec;
    private boolean blocked;
    private boolean aloft;
    private int bumps;
    private Contact contact = Contact.NONE;
    private double wallFreeMm;
    private @Nullable Pose measuredAt;
    private @Nullable Pose stuckAt;
    private @Nullable Step stuckFor;

    private Body(String name, Shape outline, Pose at) {
        this.name = name;
        this.outline = outline;
        this.reachMm = outline.reachMm();
        this.pose = at;
    }

    /**
     * A round body that turns about its centre.
     *
     * @param name of the robot
     * @param radiusMm above 0
     * @param at its start pose
     * @return the body, in no world yet
     */
    public static Body disc(String name, double radiusMm, Pose at) {
        return new Body(name, new Shape(new double[] {0}, new double[] {0}, radiusMm), at);
    }

    /**
     * A box.
     *
     * @param name of the robot
     * @param frontMm from the turning centre to the front, above 0
     * @param rearMm from the turning centre to the rear, above 0
     * @param halfWidthMm from the turning centre to either side, above 0
     * @param at its start pose
     * @return the body, in no world yet
     */
    public static Body box(String name, double frontMm, double rearMm, double halfWidthMm, Pose at) {
        double[] xs = {frontMm, frontMm, -rearMm, -rearMm};
        double[] ys = {-halfWidthMm, halfWidthMm, halfWidthMm, -halfWidthMm};
        return new Body(name, new Shape(xs, ys, 0), at);
    }

    /**
     * The robot's name.
     *
     * @return as it was given
     */
    public String name() {
        return name;
    }

    /**
     * Where it truly is.
     *
     * @return the pose of its turning centre
     */
    public Pose pose() {
        return pose;
    }

    /**
     * Lifts the body and puts it down elsewhere, with no motion in the present step.
     *
     * @param p where to
     * @throws IllegalArgumentException if it would overlap a wall or another body; it stays where it was
     */
    public void place(Pose p) {
        if (!fits.test(p)) {
            throw new IllegalArgumentException(name + " does not fit at " + p + ": a wall or another body is there");
        }
        contact = Contact.NONE;
        blocked = false;
        wallFreeMm = 0;
        moveTo(p);
    }

    /**
     * Lets the body fly above all walls and other bodies, so that it meets none and no sensor of another body detects
     * it; or puts it among them again.
     *
     * @param flies whether it is above them from now on
     */
    public void aloft(boolean flies) {
        aloft = flies;
    }

    /**
     * Whether it is above all walls and other bodies.
     *
     * @return true while it meets nothing
     */
    public boolean isAloft() {
        return aloft;
    }

    /**
     * Moves the body at once, in any direction, as a vehicle that flies moves in a step. Through a wall or another body
     * it goes only aloft.
     *
     * @param next where to, so near that nothing can be between
     * @return false if something is there; the body stayed where it was, and the first of such moves counts as a bump
     */
    public boolean slide(Pose next) {
        boolean free = fits.test(next);
        if (free) {
            wallFreeMm = 0;
            moveTo(next);
        }
        bumps += free || blocked ? 0 : 1;
        blocked = !free;
        return free;
    }

    /**
     * Sets the wanted velocity, until it is set again.
     *
     * @param mmPerSec ahead, negative backward
     * @param degPerSec counter-clockwise
     * @throws IllegalArgumentException if one is not finite; the old velocity stays
     */
    public void velocity(double mmPerSec, double degPerSec) {
        if (!Double.isFinite(mmPerSec) || !Double.isFinite(degPerSec)) {
            throw new IllegalArgumentException("a velocity must be finite: " + mmPerSec + ", " + degPerSec);
        }
        wantedMmPerSec = mmPerSec;
        wantedDegPerSec = degPerSec;
        if (!wantsToRest()) {
            departure.run();
        }
    }

    /**
     * How fast it really went in the last step.
     *
     * @return mm/s along its heading, negative backward
     */
    public double speedMmPerSec() {
        return speedMmPerSec;
    }

    /**
     * How fast it really turned in the last step.
     *
     * @return degrees per second, counter-clockwise positive
     */
    public double turnDegPerSec() {
        return turnDegPerSec;
    }

    /**
     * Whether a wall or another body cut its last step short.
     *
     * @return true if it did not get as far as it wanted
     */
    public boolean blocked() {
        return blocked;
    }

    /**
     * How often it drove into something; being driven into does not count.
     *
     * @return since it was made
     */
    public int bumps() {
        return bumps;
    }

    /**
     * What it touches after the last step, by its own motion or that of another body.
     *
     * @return the place around its outline, or {@link Contact#NONE}
     */
    public Contact contact() {
        return contact;
    }

    /**
     * Its present outline, for a drawing; a disc is drawn with many corners.
     *
     * @return corners in room coordinates, counter-clockwise
     */
    public List<Point> outline() {
        if (corners == null) {
            corners = List.copyOf(drawnCorners());
        }
        return corners;
    }

    private List<Point> drawnCorners() {
        List<Point> drawn = new ArrayList<>();
        if (outline.corners() == 1) {
            for (int i = 0; i < DISC_DRAWN_WITH_CORNERS; i++) {
                double angle = 2 * Math.PI * i / DISC_DRAWN_WITH_CORNERS;
                drawn.add(pose.toWorld(outline.roundMm * Math.cos(angle), outline.roundMm * Math.sin(angle)));
            }
            return drawn;
        }
        for (int i = 0; i < outline.corners(); i++) {
            drawn.add(pose.toWorld(outline.xs[i], outline.ys[i]));
        }
        return drawn;
    }

    /** Its outline at its present place. */
    Shape shape() {
        if (shape == null) {
            shape = outline.at(pose);
        }
        return shape;
    }

    Shape shapeAt(Pose where) {
        return where == pose ? shape() : outline.at(where);
    }

    /** How far its farthest point is from its turning centre. */
    public double reachMm() {
        return reachMm;
    }

    /** Whether a part of it may be within this distance of a place; sometimes true although none is. */
    boolean mayReach(double xMm, double yMm, double withinMm) {
        double dx = pose.xMm() - xMm;
        double dy = pose.yMm() - yMm;
        double farthest = withinMm + reachMm + Bounds.SLACK_MM;
        return dx * dx + dy * dy <= farthest * farthest;
    }

    double wantedMmPerSec() {
        return wantedMmPerSec;
    }

    double wantedDegPerSec() {
        return wantedDegPerSec;
    }

    boolean wantsToRest() {
        return wantedMmPerSec == 0 && wantedDegPerSec == 0;
    }

    /**
     * Adds the body to a room, which limits where it can be, receives the last pose after each movement, and is
     * notified when the body is to move.
     */
    void enter(Predicate<Pose> room, Consumer<Pose> moved, Runnable departs) {
        fits = room;
        movement = moved;
        departure = departs;
    }

    /** Records the motion of one step, which may be less than the commanded velocity. */
    void moved(double mmPerSec, double degPerSec, boolean cut) {
        speedMmPerSec = mmPerSec;
        turnDegPerSec = degPerSec;
        bumps += cut && !blocked ? 1 : 0;
        blocked = cut;
    }

    void contact(Contact now) {
        contact = now;
    }

    /** How far it can still go in any direction before it could touch a wall. */
    double wallFreeMm() {
        return wallFreeMm;
    }

    /** Whether this distance is exact, because the body has not moved since the measurement. */
    boolean isMeasured() {
        return measuredAt == pose;
    }

    void measured(double mm) {
        wallFreeMm = mm;
        measuredAt = pose;
    }

    void go(Pose next, double atMostMm) {
        moveTo(next);
        wallFreeMm -= atMostMm;
    }

    private void moveTo(Pose next) {
        Pose from = pose;
        pose = next;
        shape = null;
        corners = null;
        movement.accept(from);
    }

    /** Whether a wall already blocked this same step from this same pose. */
    boolean isStuck(Step step) {
        return stuckAt == pose && step.equals(stuckFor);
    }

    void stuck(Step step) {
        stuckAt = pose;
        stuckFor = step;
    }
}
