package majicsim.hemisson.board;

/** What a command may do to the robot as a whole. */
public interface RobotControl {
    /** Sets the motors, unless the running mode holds them. */
    void drive(int left, int right);

    /** Processor reset: motors 0, switches read anew, greeting. */
    void reset();
}
