package majicsim.pioneer.report;

/** A client's request for an extra packet: argument 0 none, 1 one, 2 or more one with every SIP (ARCOS sheet 6.1, 11). */
final class Subscription {
    static final int NEVER = 0;
    static final int EVERY_CYCLE = 2;

    private int wish;

    void ask(int argument) {
        wish = argument;
    }

    /** Whether one goes out with this SIP. */
    boolean isDue() {
        boolean due = wish > 0;
        if (wish == 1) {
            wish = 0;
        }
        return due;
    }
}
