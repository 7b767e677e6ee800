package majic.pioneer.session;

import majic.pioneer.arcos.ArcosCommand;
import majic.time.Signal;

/** Closes a session as the protocol demands (ARCOS sheet 13.1), on any thread; takes little over a second at most. */
final class SessionClosing {
    private static final double PAUSE_S = 0.1;

    private final ArcosLine line;
    private final Autobaud autobaud;
    private final Signal changes;

    SessionClosing(ArcosLine line, Autobaud autobaud, Signal changes) {
        this.line = line;
        this.autobaud = autobaud;
        this.changes = changes;
    }

    /** Stops the robot, switches its motors off and closes its session, as far as the line still works. */
    void run() {
        line.sendIfPossible(
                ArcosCommand.STOP.packet(),
                ArcosCommand.VEL.packet(0),
                ArcosCommand.RVEL.packet(0),
                ArcosCommand.ENABLE.packet(0));
        pause();
        autobaud.restore();
        line.sendIfPossible(ArcosCommand.CLOSE.packet(1));
        pause();
    }

    /** Gives the robot time to act, or to close the connection. */
    private void pause() {
        try {
            changes.await(line::hasEnded, PAUSE_S);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
