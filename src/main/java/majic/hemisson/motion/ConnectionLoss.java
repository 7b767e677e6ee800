package majic.hemisson.motion;

import java.io.IOException;
import java.util.function.Consumer;
import majic.bot.LinkLost;
import majic.hemisson.line.HemissonSession;
import majic.hemisson.line.StopConfirmation;

/**
 * What is done and said when nobody answers any more. A robot lost in motion is told to stand until it hears, for it has
 * no watchdog (Hemisson sheet 5). Called by the keeper and the reader; never waits.
 */
final class ConnectionLoss {
    private static final double SILENCE_S = 2;

    private final Consumer<LinkLost> lost;
    private final Consumer<String> notices;

    ConnectionLoss(Consumer<LinkLost> lost, Consumer<String> notices) {
        this.lost = lost;
        this.notices = notices;
    }

    /** Gives a connection up over which nothing was answered for too long. */
    void noticeSilence(HemissonSession open) {
        double silence = open.conversation().silentSeconds();
        if (silence < Math.max(SILENCE_S, 4 * open.timeoutSeconds())) {
            return;
        }
        boolean moving = lose(
                open,
                "connection lost: no answer for " + Math.round(silence) + " s; the robot is off or has gone deaf: "
                        + "switch it off, wait 5 s, switch it on and connect again",
                "");
        if (!moving) {
            open.close();
        }
    }

    /** Gives a connection up whose link is dead. */
    void broken(HemissonSession open, IOException cause) {
        lose(open, "connection lost: " + cause.getMessage(), "nothing in MAJIC can stop it now: ");
        open.close();
    }

    /** Tells a robot to stand that was lost in motion; the connection is closed as soon as it does. */
    void standAfter(HemissonSession open) {
        if (open.conversation().isStanding()) {
            notices.accept("it answers again and stands; connect again to go on");
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
