package majic.team;

/** The programs that share the STOP of a team: its STOP latches them, and theirs latches the team. */
@FunctionalInterface
public interface SharedStop {
    /**
     * Releases STOP for all of these programs, by {@link Team#releaseAlone} for the team, or reports to the listeners
     * of the team why it stays latched. Returns at once.
     *
     * @param decided called once when either has been done, on any thread
     */
    void release(Runnable decided);
}
