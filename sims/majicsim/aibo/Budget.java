package majicsim.aibo;

/** What the programs of all clients together may use, so that none of them can hold the kernel up. */
final class Budget {
    /** Far more than a useful program calls in 32 ms. */
    private static final int CALLS_A_PASS = 2000;

    private static final int RUNS = 1000;

    private long pass = -1;
    private int calls;
    private int runs;

    /** Whether one more function may be called in this pass of the kernel. */
    boolean takeCall(long currentPass) {
        if (currentPass != pass) {
            pass = currentPass;
            calls = 0;
        }
        return ++calls <= CALLS_A_PASS;
    }

    /** Whether one more body of a timer or an event handler may start beside those that run. */
    boolean takeRun() {
        if (runs >= RUNS) {
            return false;
        }
        runs++;
        return true;
    }

    void giveRunBack() {
        runs--;
    }
}
