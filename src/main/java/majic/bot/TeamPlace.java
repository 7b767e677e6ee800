package majic.bot;

/** The place of a robot in a team. Implemented by the team, so that a robot does not depend on teams. */
public interface TeamPlace {
    /**
     * The number of the robot.
     *
     * @return 1 to the size of the team
     */
    int number();

    /**
     * Ends scripts, acts and manual control of the robot after the connection was lost. Must not wait.
     *
     * @param reason how the connection was lost, one sentence
     */
    void linkLost(String reason);
}
