package majicsim.pioneer.motion;

/** The set-point of a motion channel; holds until replaced (ARCOS sheet 7.1). */
sealed interface Goal {
    Goal STOP = new Speed(0);

    /** The next phase of constant acceleration on the way from here to the goal. */
    Phase next(Travel from, Limits limits);

    /** Go on at this speed, signed. */
    record Speed(double perSecond) implements Goal {
        @Override
        public Phase next(Travel from, Limits limits) {
            double wanted = Math.copySign(Math.min(Math.abs(perSecond), limits.speedTowards(perSecond)), perSecond);
            return Phase.toSpeed(from, wanted, limits);
        }
    }

    /** Come to rest at this position. */
    record Position(double target) implements Goal {
        @Override
        public Phase next(Travel from, Limits limits) {
            return Phase.toPosition(from, target, limits);
        }
    }
}
