package majicsim.aibo.urbi.run;

/** The limits of the programs of all clients together, so that none of them can block the kernel. */
public final class Budget {
    /** Far more than a useful program calls in 32 ms. */
    private static final int CALLS_A_PASS = 2000;

    private static final int RUNS = 1000;

    private static final int MOST_RUNNING = 4000;
    private static final int CHARACTERS_A_CALL = 256;

    private long pass = -1;
    private int calls;
    private int runs;
    private int running;
    private int ranBefore;

    /** Counts a call of a function; returns false if this pass of the kernel has no more. */
    boolean takeCall(long currentPass) {
        return takeCalls(currentPass, 1);
    }

    /** Whether text of that length may be run as a program in this pass: it counts for as many calls as it is long. */
    public boolean takeText(long currentPass, int characters) {
        return takeCalls(currentPass, characters / CHARACTERS_A_CALL);
    }

    private boolean takeCalls(long currentPass, int count) {
        if (currentPass != pass) {
            pass = currentPass;
            calls = 0;
        }
        calls += count;
        return calls <= CALLS_A_PASS;
    }

    /** Begins a cycle, which counts all running commands anew. */
    public void beginCycle() {
        ranBefore = running;
        running = 0;
    }

    /** Counts a command that continues after its step. */
    void countRunning() {
        running++;
    }

    /** Whether the limit is reached, so that no other command may begin. */
    boolean isCrowded() {
        return Math.max(running, ranBefore) >= MOST_RUNNING;
    }

    /** Whether one more body of a timer or an event handler may start beside those that run. */
    public boolean takeRun() {
        if (runs >= RUNS) {
            return false;
        }
        runs++;
        return true;
    }

    public void giveRunBack() {
        runs--;
    }
}
