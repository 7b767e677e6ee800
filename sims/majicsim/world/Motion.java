package majicsim.world;

/**
 * Moves bodies by their commanded velocities. A step that would end in a wall or another body is shortened: first
 * straight, as far as possible, then the turn alone, so that a blocked robot can still turn away.
 */
final class Motion {
    /** The longest piece of motion of any point of a body, so that nothing jumps over a wall. */
    private static final double PIECE_MM = 10;

    private static final double TOUCH_MM = 1;
    private static final int HALVINGS = 9;

    private final Obstacles obstacles;

    Motion(Obstacles obstacles) {
        this.obstacles = obstacles;
    }

    void advance(Body body, double seconds) {
        if (seconds <= 0 || body.wantsToRest()) {
            body.moved(0, 0, false);
            return;
        }
        Step wanted = new Step(body.wantedMmPerSec() * seconds, body.wantedDegPerSec() * seconds);
        int pieces = (int) Math.ceil(wanted.travelMm(body.reachMm()) / PIECE_MM);
        Step one = new Step(wanted.mm() / pieces, wanted.deg() / pieces);
        Step done = Step.NONE;
        for (int i = 0; i < pieces; i++) {
            done = done.plus(piece(body, one));
        }
        boolean cut = !done.isAbout(wanted.mm(), wanted.deg());
        body.moved(done.mm() / seconds, done.deg() / seconds, cut);
    }

    /** Updates what the body touches. */
    void detectContact(Body body, boolean anyBlocked) {
        boolean mayTouch = !body.isAloft() && (anyBlocked || body.contact().touching());
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
        if (body.isStuck(wanted)) {
            return Step.NONE;
        }
        if (go(body, wanted)) {
            return wanted;
        }
        Step done = farthest(body, new Step(wanted.mm(), 0)).plus(farthest(body, new Step(0, wanted.deg())));
        if (done.isNone() && isRefusedByWalls(body, wanted)) {
            body.stuck(wanted);
        }
        return done;
    }

    /** Walls do not move, so a blocked step stays blocked; storing this saves the search while a robot pushes. */
    private boolean isRefusedByWalls(Body body, Step wanted) {
        double least = Math.pow(0.5, HALVINGS);
        Pose straight = body.pose().driven(wanted.mm() * least, 0);
        Pose turned = body.pose().driven(0, wanted.deg() * least);
        return (wanted.mm() == 0 || !obstacles.areWallsClearOf(body, straight))
                && (wanted.deg() == 0 || !obstacles.areWallsClearOf(body, turned));
    }

    /** Moves as much of the step as there is room for. */
    private Step farthest(Body body, Step wanted) {
        if (wanted.isNone() || go(body, wanted)) {
            return wanted;
        }
        Step done = Step.NONE;
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
        double travelMm = step.travelMm(body.reachMm());
        if (!obstacles.areClearOf(body, next, travelMm)) {
            return false;
        }
        body.go(next, travelMm);
        return true;
    }
}
