package majic.pioneer.session;

import majic.pioneer.arcos.ArcosCommand;
import majic.time.Signal;

/** Ends a session in good order (ARCOS sheet 13.1), on any thread; bounded by little over a second. */
final class SessionClosing {
    private static final double GOODBYE_S = 0.1;

    private final ArcosLine line;
    private final Autobaud autobaud;
    private final Signal changes;

    SessionClosing(ArcosLine line, Autobaud autobaud, Signal changes) {
        this.line = line;
        this.autobaud = autobaud;
        this.changes = changes;
    }

    /** Stops the robot, switches its motors off and leaves its session, as far as the line still carries that. */
    void run() {
        line.sendIfPossible(
                ArcosCommand.STOP.packet(),
                ArcosCommand.VEL.packet(0),
                ArcosCommand.RVEL.packet(0),
                ArcosCommand.ENABLE.packet(0));
        linger();
        autobaud.restore();
        line.sendIfPossible(ArcosCommand.CLOSE.packet(1));
        linger();
    }

    /** Gives the robot the time it needs, or to hang up by itself. */
    private void linger() {
        try {
            changes.await(line::hasEnded, GOODBYE_S);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
