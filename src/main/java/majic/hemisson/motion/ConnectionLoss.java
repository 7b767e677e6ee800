package majic.hemisson.motion;

import java.io.IOException;
import java.util.function.Consumer;
import majic.bot.LinkLost;
import majic.hemisson.line.HemissonSession;
import majic.hemisson.line.StopConfirmation;

/**
 * Gives up connections that are lost or silent, and repeats the stop of a robot that was lost in motion until it
 * confirms: it has no watchdog (Hemisson sheet 5). Called by the timer thread and the reader; never blocks.
 */
final class ConnectionLoss {
    private static final double SILENCE_S = 2;

    private final Consumer<LinkLost> lost;
    private final Consumer<String> notices;

    ConnectionLoss(Consumer<LinkLost> lost, Consumer<String> notices) {
        this.lost = lost;
        this.notices = notices;
    }

    /** Gives up a connection without answers for too long. */
    void noticeSilence(HemissonSession open) {
        double silence = open.conversation().silentSeconds();
        if (silence < Math.max(SILENCE_S, 4 * open.timeoutSeconds())) {
            return;
        }
        boolean moving = lose(
                open,
                "connection lost: no answer for " + Math.round(silence)
                        + " s; the robot is off or receives nothing any more: "
                        + "switch it off, wait 5 s, switch it on and connect again",
                "");
        if (!moving) {
            open.close();
        }
    }

    /** Gives up a connection whose link has failed. */
    void broken(HemissonSession open, IOException cause) {
        lose(open, "connection lost: " + cause.getMessage(), "nothing in MAJIC can stop it now: ");
        open.close();
    }

    /** Repeats the stop of a robot that was lost in motion; closes the connection once it is confirmed. */
    void stopAfterLoss(HemissonSession open) {
        if (open.conversation().isStopped()) {
            notices.accept("it answers again and has stopped; connect again to continue");
            open.close();
        } else {
            open.conversation().stop();
        }
    }

    private boolean lose(HemissonSession open, String how, String moved) {
        boolean moving = open.conversation().mayMove();
        lost.accept(new LinkLost(moving ? how + "; " + moved + StopConfirmation.HELP : how));
        return moving;
    }
}
