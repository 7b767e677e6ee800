package majicsim.world;

/**
 * Moves bodies by their wanted velocities. A step that would end in a wall or another body is cut: first it is tried straight, as far
 * as it goes, then the turn alone, so that a blocked robot can still turn away.
 */
final class Motion {
    /** No point of a body moves farther in one piece, so nothing jumps over a wall. */
    private static final double PIECE_MM = 10;

    private static final double TOUCH_MM = 1;
    private static final int HALVINGS = 9;

    private final Obstacles obstacles;

    Motion(Obstacles obstacles) {
        this.obstacles = obstacles;
    }

    void advance(Body body, double seconds) {
        double path = body.wantedMmPerSec() * seconds;
        double turn = body.wantedDegPerSec() * seconds;
        if (seconds <= 0 || (path == 0 && turn == 0)) {
            body.moved(0, 0, false);
            return;
        }
        int pieces = (int) Math.ceil(travel(body, path, turn) / PIECE_MM);
        Step done = new Step(0, 0);
        for (int i = 0; i < pieces; i++) {
            done = done.plus(piece(body, new Step(path / pieces, turn / pieces)));
        }
        boolean cut = !done.isAbout(path, turn);
        body.moved(done.mm() / seconds, done.deg() / seconds, cut);
    }

    /** Updates what the body touches. */
    void feel(Body body, boolean anyBlocked) {
        boolean mayTouch = anyBlocked || body.contact().touching();
        body.contact(mayTouch ? touched(body) : Contact.NONE);
    }

    private Contact touched(Body body) {
        Gap gap = obstacles.nearest(body, TOUCH_MM);
        if (gap.mm() > TOUCH_MM) {
            return Contact.NONE;
        }
        Point local = body.pose().toLocal(gap.nearest());
        return new Contact(true, Math.toDegrees(Math.atan2(local.yMm(), local.xMm())));
    }

    private Step piece(Body body, Step wanted) {
        if (go(body, wanted)) {
            return wanted;
        }
        Step straight = farthest(body, new Step(wanted.mm(), 0));
        Step turn = farthest(body, new Step(0, wanted.deg()));
        return straight.plus(turn);
    }

    /** Goes as much of the step as there is room for. */
    private Step farthest(Body body, Step wanted) {
        if (wanted.isNone() || go(body, wanted)) {
            return wanted;
        }
        Step done = new Step(0, 0);
        Step half = wanted.half();
        for (int i = 0; i < HALVINGS; i++) {
            if (go(body, half)) {
                done = done.plus(half);
            }
            half = half.half();
        }
        return done;
    }

    private boolean go(Body body, Step step) {
        Pose next = body.pose().driven(step.mm(), step.deg());
        double travel = travel(body, step.mm(), step.deg());
        if (!obstacles.areClearOf(body, next, travel)) {
            return false;
        }
        body.pose(next);
        body.wallFreeMm(body.wallFreeMm() - travel);
        return true;
    }

    /** The most any point of the body can move. */
    private static double travel(Body body, double path, double turn) {
        return Math.abs(path) + Math.abs(Math.toRadians(turn)) * body.reachMm();
    }

    private record Step(double mm, double deg) {
        Step plus(Step other) {
            return new Step(mm + other.mm, deg + other.deg);
        }

        Step half() {
            return new Step(mm / 2, deg / 2);
        }

        boolean isNone() {
            return mm == 0 && deg == 0;
        }

        boolean isAbout(double path, double turn) {
            return Math.abs(mm - path) < 1e-6 && Math.abs(deg - turn) < 1e-6;
        }
    }
}
