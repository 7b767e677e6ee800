package majic.bot;

/** The place of a robot in a team. Implemented by the team, so that a robot does not depend on teams. */
public interface TeamPlace {
    /**
     * The number of the robot.
     *
     * @return 1 to the size of the team
     */
    int number();
}
