package majic.team;

/** The programs that share the STOP of a team: its STOP latches them, and theirs latches the team. */
public interface SharedStop {
    /**
     * Receives that STOP of the team was latched or released; after the bytes of a STOP were given to the connections,
     * unless it is released meanwhile. Calls of this method and of {@link #release} come one at a time, in the order of
     * the changes, whatever the listeners of the team do, on any thread. Returns at once.
     *
     * @param latched true after STOP
     */
    void latchChanged(boolean latched);

    /**
     * Releases STOP for all of these programs, by {@link Team#releaseAlone} for the team, or reports to the listeners
     * of the team why it stays latched. Returns at once.
     *
     * @param decided called once when either has been done, on any thread
     */
    void release(Runnable decided);
}
