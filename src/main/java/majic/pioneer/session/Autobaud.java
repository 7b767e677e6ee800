package majic.pioneer.session;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.bot.BotException;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Config;
import org.jspecify.annotations.Nullable;

/**
 * Makes a serial line faster where the robot allows it: at {@value BaudRates#POWER_UP} baud one SIP with 16 readings fills the
 * whole cycle (ARCOS sheet 1). A robot that hears nothing valid for 500 ms falls back by itself, and so does this side.
 */
final class Autobaud {
    private static final Logger LOG = System.getLogger(Autobaud.class.getName());

    /** The value of CONFIG's AUTOBAUD that asks for it (ARCOS sheet 1). */
    private static final int AUTOMATIC = 2;

    /** Until the command is out of the port and the robot has obeyed. */
    private static final double SETTLE_S = 0.05;

    private static final double PULSE_S = 0.1;
    private static final int PULSES = 6;

    /** The first SIPs after the change may have come before it, at the other speed, and have waited to be read. */
    private static final int PROOFS = 3;

    /** The robot's own 500 ms, and then a SIP (ARCOS sheet 6.1, HOSTBAUD). */
    private static final double FALL_BACK_S = 1;

    private final ArcosLine line;
    private final ReportedState state;
    private volatile boolean raised;

    Autobaud(ArcosLine line, ReportedState state) {
        this.line = line;
        this.state = state;
    }

    /**
     * Changes the speed if the line has one, is still slow and the robot asks for it.
     *
     * @param rate what the line is set to, baud
     * @throws BotException if the robot is not heard any more at either speed
     */
    void run(@Nullable Config config, int rate) {
        if (config == null || config.autobaud() != AUTOMATIC || rate != BaudRates.POWER_UP || !line.setBaud(rate)) {
            return;
        }
        change(BaudRates.FAST_CODE, BaudRates.FAST);
        raised = isHeard();
        if (!raised) {
            fallBack();
        }
    }

    /**
     * Makes the line as slow again as it was, for the next program that looks for the robot there. A robot that is not heard
     * then is told to end the session at either speed. For the end of a session; throws nothing.
     */
    void restore() {
        try {
            if (raised && !line.hasEnded()) {
                raised = false;
                slowDown();
            }
        } catch (BotException e) {
            LOG.log(Level.DEBUG, () -> line.address() + " was not made slow again: " + e.getMessage());
        }
    }

    private void slowDown() {
        change(BaudRates.POWER_UP_CODE, BaudRates.POWER_UP);
        if (!isHeard()) {
            line.send(ArcosCommand.CLOSE.packet(1));
            settle();
            line.setBaud(BaudRates.FAST);
        }
    }

    private void change(int code, int baud) {
        line.send(ArcosCommand.HOSTBAUD.packet(code));
        settle();
        line.setBaud(baud);
    }

    private void settle() {
        state.await(any -> false, SETTLE_S);
    }

    /** Any valid packet of ours tells the robot that the change has worked. */
    private boolean isHeard() {
        int proofs = 0;
        for (int pulse = 0; pulse < PULSES && proofs < PROOFS; pulse++) {
            long seen = state.get().atNanos();
            line.send(ArcosCommand.PULSE.packet());
            if (state.await(now -> now.atNanos() != seen, PULSE_S)) {
                proofs++;
            }
        }
        return proofs == PROOFS;
    }

    private void fallBack() {
        LOG.log(Level.DEBUG, () -> line.address() + " does not follow to " + BaudRates.FAST + " baud");
        line.setBaud(BaudRates.POWER_UP);
        long seen = state.get().atNanos();
        if (!state.await(now -> now.atNanos() != seen, FALL_BACK_S)) {
            throw new BotException(line.address() + " is not heard any more since its speed was to change from "
                    + BaudRates.POWER_UP + " to " + BaudRates.FAST + " baud; try again");
        }
    }
}
