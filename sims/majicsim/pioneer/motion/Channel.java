package majicsim.pioneer.motion;

/**
 * One of the two motion channels (ARCOS sheet 7.1): follows its goal along linear speed ramps. Each lab step is planned
 * first and completed afterwards, when the motion that was possible in the world is known; a goal that changes in
 * between changes the plan at once.
 */
final class Channel {
    /** How long an emergency stop takes: less than one SIP cycle, whatever the speed (ARCOS sheet 6.1, ESTOP). */
    private static final double EMERGENCY_SECONDS = 0.08;
    /** More phases than any real ramp has in one step; ends a chain of empty ones. */
    private static final int MOST_PHASES = 16;

    private Limits limits;
    private Goal goal = Goal.STOP;
    private Travel now = Travel.REST;
    private Travel planned = Travel.REST;
    private boolean held;
    private double emergencyDeceleration;

    Channel(Limits limits) {
        this.limits = limits;
    }

    Limits limits() {
        return limits;
    }

    void limits(Limits newLimits) {
        limits = newLimits;
    }

    /** Sets a new goal; ignored while an emergency stop is under way. */
    void follow(Goal newGoal) {
        if (!isInEmergency()) {
            goal = newGoal;
        }
    }

    Goal goal() {
        return goal;
    }

    /** Stops and keeps the goal, or continues to it (ARCOS sheet 5.3). */
    void hold(boolean hold) {
        held = hold;
    }

    void emergencyStop() {
        goal = Goal.STOP;
        emergencyDeceleration = Math.max(limits.deceleration(), Math.abs(now.speed()) / EMERGENCY_SECONDS);
    }

    boolean isInEmergency() {
        return emergencyDeceleration > 0;
    }

    double position() {
        return now.position();
    }

    double speed() {
        return now.speed();
    }

    /** Whether it does not move, now and in the planned step. */
    boolean isAtRest() {
        return now.speed() == 0 && planned.speed() == 0 && planned.position() == now.position();
    }

    /** The mean speed of the coming step, with which the distance is exactly that of the ramps. */
    double plan(double seconds) {
        Travel at = now;
        double left = seconds;
        for (int phases = 0; left > 0 && phases < MOST_PHASES; phases++) {
            Phase phase = effectiveGoal().next(at, effectiveLimits());
            boolean ends = phase.seconds() <= left;
            at = ends ? phase.end() : at.after(left, phase.acceleration());
            left = ends ? left - phase.seconds() : 0;
        }
        planned = at;
        return (planned.position() - now.position()) / seconds;
    }

    /** Completes a step that went as planned. */
    void follow() {
        arrive(planned);
    }

    /** Completes a step that was shortened: only this distance was covered, and the wheels are stopped. */
    void blockAfter(double way) {
        arrive(new Travel(now.position() + way, 0));
    }

    private void arrive(Travel at) {
        now = at;
        planned = at;
        if (at.speed() == 0) {
            emergencyDeceleration = 0;
        }
    }

    private Goal effectiveGoal() {
        return held ? Goal.STOP : goal;
    }

    private Limits effectiveLimits() {
        return isInEmergency() ? limits.withDeceleration(emergencyDeceleration) : limits;
    }
}
