package majic.pioneer.line;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.function.BooleanSupplier;
import java.util.function.IntSupplier;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.driver.RobotWait;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Config;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Raises the speed of a serial line where the robot allows it: at {@value BaudRates#POWER_UP} baud one SIP with 16
 * readings fills the whole cycle (ARCOS sheet 1). A robot that receives no valid packet for 500 ms falls back to the
 * earlier speed; then this side falls back too.
 */
final class Autobaud {
    private static final Logger LOG = System.getLogger(Autobaud.class.getName());

    /** The value of CONFIG's AUTOBAUD that requests a change of speed (ARCOS sheet 1). */
    private static final int AUTOMATIC = 2;

    /** Time for the command to leave the port and to take effect in the robot. */
    private static final double SETTLE_S = 0.05;

    private static final double PULSE_S = 0.1;
    private static final int PULSES = 6;

    /** More than one, because the first SIP may have come at the old speed and waited in a buffer. */
    private static final int PROOFS = 3;

    /** The robot's 500 ms, and time for one SIP (ARCOS sheet 6.1, HOSTBAUD). */
    private static final double FALL_BACK_S = 1;

    private final ArcosLine line;
    private final IntSupplier sips;
    private final RobotWait waiting;
    private volatile boolean raised;

    /**
     * For one connection.
     *
     * @param sips returns how many SIPs have come
     * @param waiting woken after each SIP
     */
    Autobaud(ArcosLine line, IntSupplier sips, RobotWait waiting) {
        this.line = line;
        this.sips = sips;
        this.waiting = waiting;
    }

    /**
     * Raises the speed if the line is a serial port at the power-up speed and the robot requests it.
     *
     * @param rate what the line is set to, baud
     * @throws BotException if nothing is received any more at either speed
     */
    void run(@Nullable Config config, int rate) {
        if (config == null || config.autobaud() != AUTOMATIC || rate != BaudRates.POWER_UP || !line.setBaud(rate)) {
            return;
        }
        change(BaudRates.FAST_CODE, BaudRates.FAST);
        raised = isConfirmed();
        if (!raised) {
            fallBack();
        }
    }

    /**
     * Restores the power-up speed at the end of a session, at which the next program expects the robot. If nothing is
     * received after that, CLOSE is sent at both speeds. Throws nothing.
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
        if (!isConfirmed()) {
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
        await(() -> false, SETTLE_S);
    }

    /** Sends pulses: any valid packet confirms the new speed to the robot. */
    private boolean isConfirmed() {
        int proofs = 0;
        for (int pulse = 0; pulse < PULSES && proofs < PROOFS; pulse++) {
            int before = sips.getAsInt();
            line.send(ArcosCommand.PULSE.packet());
            if (await(() -> sips.getAsInt() > before, PULSE_S)) {
                proofs++;
            }
        }
        return proofs == PROOFS;
    }

    /** Waits until a condition holds; a thread that must not wait, or is interrupted, only tests it. */
    boolean await(BooleanSupplier condition, double seconds) {
        return waiting.awaitClosing(condition, WaitPolicy.isAllowed() ? seconds : 0);
    }

    private void fallBack() {
        LOG.log(Level.DEBUG, () -> line.address() + " does not follow to " + BaudRates.FAST + " baud");
        line.setBaud(BaudRates.POWER_UP);
        int before = sips.getAsInt();
        if (!await(() -> sips.getAsInt() > before, FALL_BACK_S)) {
            throw new ConnectFailed(
                    Reason.NO_ANSWER,
                    line.address() + " is not heard any more since its speed was to change from " + BaudRates.POWER_UP
                            + " to " + BaudRates.FAST + " baud; try again");
        }
    }
}
