package majic.driver;

/** The membership of a robot in a team. Implemented by the team, so that a robot does not depend on teams. */
public interface TeamMembership {
    /**
     * Returns the number of the robot in the team.
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

    /**
     * Ends everything that moves the robot, because another program has stopped it: revokes permits, empties the queue,
     * ends scripts, acts and manual control. Sends the robot nothing. Must not wait.
     */
    default void stoppedElsewhere() {}
}
