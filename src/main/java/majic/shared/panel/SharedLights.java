package majic.shared.panel;

import java.util.List;
import majic.bot.MajicBot;
import majic.panel.ReadingText;
import majic.panel.StatusLight;
import majic.panel.StatusLight.Kind;
import majic.panel.StatusLightsPanel;
import majic.text.Texts;

/** The holder of a shared robot and its connection, each shown as a word and a shape. For the event dispatch thread. */
final class SharedLights {
    private static final Texts TEXTS = Texts.of(SharedLights.class);
    private static final double OLD_S = 1.5;

    private final StatusLight holder = new StatusLight("holder", TEXTS.get("holder.tip"));
    private final StatusLight link = new StatusLight("link", TEXTS.get("link.tip"));
    private final StatusLightsPanel panel = new StatusLightsPanel(TEXTS.get("holder.longest"), List.of(holder, link));

    StatusLightsPanel panel() {
        return panel;
    }

    void show(MajicBot bot, SharedScene scene) {
        panel.setCurrent(bot.isConnected());
        link.setEnabled(true);
        showHolder(scene);
        double ageS = bot.time().secondsSince(bot.state().atNanos());
        if (bot.connection() == MajicBot.Connection.CONNECTING) {
            link.show(Kind.QUIET, TEXTS.get("link.connecting"));
        } else if (!bot.isConnected()) {
            link.show(Kind.ALARM, TEXTS.get("link.lost"));
        } else if (ageS > OLD_S) {
            link.show(Kind.WARNING, TEXTS.get("link.old", ReadingText.age(ageS)));
        } else {
            link.show(Kind.GOOD, TEXTS.get("link.good", scene.delay()));
        }
    }

    /** Another holder needs attention: it has to free the robot before this program can move it. */
    private void showHolder(SharedScene scene) {
        if (scene.holder().isEmpty()) {
            holder.show(Kind.QUIET, TEXTS.get("holder.none"));
        } else if (scene.heldHere()) {
            holder.show(Kind.GOOD, TEXTS.get("holder.here"));
        } else {
            holder.show(Kind.WARNING, scene.holder());
        }
    }
}
