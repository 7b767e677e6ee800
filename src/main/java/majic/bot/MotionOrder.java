package majic.bot;

/** A motion as a value: it can be checked, and performed later. Immutable. */
public sealed interface MotionOrder {
    /**
     * Checks the numbers against the limits of a robot.
     *
     * @param bot sends nothing to it
     * @throws ParameterException if the robot does not accept them; the message says what it accepts
     */
    void check(MajicBot bot);

    /**
     * Performs the motion, and blocks until it has ended.
     *
     * @param robot the robot to move
     * @param until ends the motion early
     * @return how far it went
     * @throws BotException as the method of {@link BotControl} for this motion
     */
    MotionReport perform(BotControl robot, Guard until);

    /**
     * Straight motion.
     *
     * @param mm ahead positive
     */
    record Move(double mm) implements MotionOrder {
        @Override
        public void check(MajicBot bot) {
            bot.checkMove(mm);
        }

        @Override
        public MotionReport perform(BotControl robot, Guard until) {
            return robot.move(mm, until);
        }
    }

    /**
     * Turn on the spot.
     *
     * @param degrees counterclockwise positive
     */
    record Turn(double degrees) implements MotionOrder {
        @Override
        public void check(MajicBot bot) {
            bot.checkTurn(degrees);
        }

        @Override
        public MotionReport perform(BotControl robot, Guard until) {
            return robot.turn(degrees, until);
        }
    }

    /**
     * Curve for a time.
     *
     * @param mmPerSec ahead positive
     * @param degPerSec counterclockwise positive
     * @param seconds above 0
     */
    record Drive(double mmPerSec, double degPerSec, double seconds) implements MotionOrder {
        @Override
        public void check(MajicBot bot) {
            bot.checkDrive(mmPerSec, degPerSec, seconds);
        }

        @Override
        public MotionReport perform(BotControl robot, Guard until) {
            return robot.drive(mmPerSec, degPerSec, seconds, until);
        }
    }
}
