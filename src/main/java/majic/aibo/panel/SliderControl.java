package majic.aibo.panel;

import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.team.ManualControl;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Moves joints of one robot as the user drags sliders: takes manual control when a drag begins, by the same rules as
 * every other control, and releases it when the last joint has arrived. A stop ends it until the next drag. Never
 * waits; used by one thread.
 */
final class SliderControl {
    private final MajicBot bot;
    private @Nullable ManualControl control;
    private boolean dragging;
    private boolean taken;

    SliderControl(MajicBot bot) {
        this.bot = bot;
    }

    /** Whether the last chosen angle is not yet reached. */
    boolean isHolding() {
        return control != null && !control.isOff();
    }

    /** Chooses an angle; a refusal is shown to the user once a drag. */
    void choose(String joint, double degrees, boolean last) {
        if (!dragging) {
            dragging = true;
            taken = take(joint, degrees);
        } else if (taken && control != null) {
            control.set(joint, degrees);
        }
        if (last) {
            dragging = false;
            if (control != null) {
                control.finish();
            }
        }
    }

    private boolean take(String joint, double degrees) {
        if (control != null && control.set(joint, degrees)) {
            return true;
        }
        Member.of(bot).ifPresent(member -> {
            try {
                control = new ManualControl(member);
                control.set(joint, degrees);
            } catch (BotException e) {
                control = null;
                member.report(e);
            }
        });
        return control != null;
    }
}
