package majic.team;

/** Receives the beginning of commands from the queues of robots. */
@FunctionalInterface
public interface CommandListener {
    /**
     * A robot begins a command of its queue. Called on the robot's worker thread before the command has any effect, so
     * a listener that blocks delays the command; it delays no stop. Return quickly, and use another thread for anything
     * slow.
     *
     * @param robot its number
     * @param command its text without the robot's number
     */
    void begun(int robot, String command);
}
