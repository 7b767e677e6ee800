package majic.bot;

/**
 * Finds how far one robot can drive before it comes too close to something: what guarded driving goes by. Thread-safe.
 */
public interface DriveGuard {
    /**
     * Returns whether there is anything to go by.
     *
     * @return false for a robot without sensors for it, as long as no map shows what is around it
     */
    boolean isPossible();

    /**
     * Returns how far the robot can go on at some speeds. Reads what it needs from now on, for some seconds. Called on
     * the thread of a motion, of listeners or of a drive by hand, never under a lock of the driver; must not wait.
     *
     * @param mmPerSec the speed, ahead positive; 0 for a turn on the spot
     * @param degPerSec the turn rate, counterclockwise positive
     * @return the room
     */
    Room room(double mmPerSec, double degPerSec);

    /**
     * The way that is free.
     *
     * @param mm how far the robot may go, infinite if nothing is near; 0 if it must stand
     * @param reason what is in the way, or which reading is missing, as half a sentence; empty if nothing is
     */
    record Room(double mm, String reason) {
        /** Nothing is near. */
        public static final Room FREE = new Room(Double.POSITIVE_INFINITY, "");

        /** The first reading has not come yet; the robot stands until it does, a second at most. */
        public static final Room WAITING = new Room(0, "it waits for a reading of its sensors");

        /** How hard a robot is expected to brake, and how long until it does. */
        private static final double BRAKING_MM_PER_S2 = 250;

        private static final double REACTION_S = 0.25;

        /**
         * Returns how far a robot goes until it is stationary.
         *
         * @param mmPerSec its speed, either sign
         * @return mm
         */
        public static double brakingMm(double mmPerSec) {
            double speed = Math.abs(mmPerSec);
            return speed * REACTION_S + speed * speed / (2 * BRAKING_MM_PER_S2);
        }

        /**
         * Returns the speed from which a robot becomes stationary within this room.
         *
         * @return mm/s
         */
        public double speedMmPerSec() {
            double delay = BRAKING_MM_PER_S2 * REACTION_S;
            return mm <= 0 ? 0 : Math.sqrt(delay * delay + 2 * BRAKING_MM_PER_S2 * mm) - delay;
        }
    }
}
