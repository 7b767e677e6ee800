package majic.driver;

/**
 * Parameters of a robot that belong together, such as those of its battery.
 *
 * @param <E> describes the equipment of the robot, on which the parameters depend
 */
public interface ParameterTheme<E> {
    /**
     * Adds the parameters that a robot with this equipment has.
     *
     * @param table lists the parameters in the order of the calls
     * @param equipment of the robot
     */
    void describe(ParameterTable table, E equipment);

    /** Ends what setting one of the parameters has started, when the robot is stopped. Waits for nothing. */
    default void halt() {}
}
