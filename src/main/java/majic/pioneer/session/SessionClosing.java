package majic.pioneer.session;

import majic.driver.RobotWait;
import majic.pioneer.arcos.ArcosCommand;

/** Closes a session as the protocol demands (ARCOS sheet 13.1), on any thread; takes little over a second at most. */
final class SessionClosing {
    private static final double PAUSE_S = 0.1;

    private final ArcosLine line;
    private final Autobaud autobaud;
    private final RobotWait waiting;

    SessionClosing(ArcosLine line, Autobaud autobaud, RobotWait waiting) {
        this.line = line;
        this.autobaud = autobaud;
        this.waiting = waiting;
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
        waiting.awaitClosing(line::hasEnded, PAUSE_S);
    }
}
