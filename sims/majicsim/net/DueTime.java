package majicsim.net;

/**
 * When a task of a lab must run next; everything that gives it something to do lowers the time. Guarded by the lab's
 * lock.
 *
 * @param time of the lab
 * @param task its number
 */
public record DueTime(LabTime time, int task) {
    /**
     * Lets the task run at this time, or earlier.
     *
     * @param labNanos ns since the lab was opened; a time that has passed means the next step, or this one if its turn
     *     is still to come
     */
    public void atLatest(long labNanos) {
        time.lowerDue(task, labNanos);
    }
}
