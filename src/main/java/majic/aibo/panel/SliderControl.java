package majic.aibo.panel;

import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.team.ManualControl;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Moves joints of one robot as a person drags sliders: takes manual control when a drag begins, by the same rules as every
 * other control, and releases it when the last joint has arrived. A stop ends it until the next drag. Never
 * waits; used by one thread.
 */
final class SliderControl {
    private final MajicBot bot;
    private @Nullable ManualControl hand;
    private boolean dragging;
    private boolean held;

    SliderControl(MajicBot bot) {
        this.bot = bot;
    }

    /** Whether what was chosen last is still being done. */
    boolean isHolding() {
        return hand != null && !hand.isOff();
    }

    /** Chooses an angle; a refusal is shown to the user once a drag. */
    void choose(String joint, double degrees, boolean last) {
        if (!dragging) {
            dragging = true;
            held = take(joint, degrees);
        } else if (held && hand != null) {
            hand.set(joint, degrees);
        }
        if (last) {
            dragging = false;
            if (hand != null) {
                hand.finish();
            }
        }
    }

    private boolean take(String joint, double degrees) {
        if (hand != null && hand.set(joint, degrees)) {
            return true;
        }
        Member.of(bot).ifPresent(member -> {
            try {
                hand = new ManualControl(member);
                hand.set(joint, degrees);
            } catch (BotException e) {
                hand = null;
                member.report(e);
            }
        });
        return hand != null;
    }
}
