package majic.mavlink.panel;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import majic.bot.MajicBot;
import majic.bot.Reading;
import majic.bot.Value;
import majic.panel.ReadingText;
import majic.panel.StatusLight;
import majic.panel.StatusLight.Kind;
import majic.panel.StatusLightsPanel;
import majic.text.Texts;

/** Armed, failsafe, satellites and link, each shown as a word and a shape. For the event dispatch thread. */
final class VehicleLights {
    private static final Texts TEXTS = Texts.of(VehicleLights.class);
    private static final double SILENT_S = 1.2;
    private static final double MS_PER_S = 1000;

    /** Without a position, the words of the driver begin with this. */
    private static final String NO_FIX = "no ";

    private final StatusLight armed = new StatusLight("armed", TEXTS.get("armed.tip"));
    private final StatusLight failsafe = new StatusLight("failsafe", TEXTS.get("failsafe.tip"));
    private final StatusLight satellites = new StatusLight("satellites", TEXTS.get("satellites.tip"));
    private final StatusLight link = new StatusLight("link", TEXTS.get("link.tip"));
    private final StatusLightsPanel panel = new StatusLightsPanel(
            List.of(
                    TEXTS.get("armed.no"),
                    TEXTS.get("armed.yes"),
                    TEXTS.get("failsafe.no"),
                    TEXTS.get("failsafe.yes"),
                    TEXTS.get("satellites", "3-D", "88"),
                    TEXTS.get("satellites.noFix", "88"),
                    TEXTS.get("link.lost")),
            List.of(armed, failsafe, satellites, link));

    StatusLightsPanel panel() {
        return panel;
    }

    /**
     * Shows the conditions.
     *
     * @param isFailsafe whether a failsafe is in force; empty if that is not known
     */
    void show(MajicBot bot, Optional<Boolean> isFailsafe) {
        panel.setCurrent(bot.isConnected());
        link.setEnabled(true);
        showArmed(value(bot, "armed"));
        showFailsafe(isFailsafe);
        showSatellites(value(bot, "fix"), value(bot, "satellites"));
        showLink(bot);
    }

    private static Value value(MajicBot bot, String parameter) {
        Reading reading = bot.reading(parameter);
        return bot.isConnected() ? reading.value() : reading.last();
    }

    private void showArmed(Value now) {
        if (now instanceof Value.Flag flag) {
            armed.show(
                    flag.yes() ? Kind.WARNING : Kind.QUIET,
                    flag.yes() ? TEXTS.get("armed.yes") : TEXTS.get("armed.no"));
        } else {
            armed.show(Kind.QUIET, TEXTS.get("armed.unknown"));
        }
    }

    private void showFailsafe(Optional<Boolean> is) {
        if (is.isEmpty()) {
            failsafe.show(Kind.QUIET, TEXTS.get("failsafe.unknown"));
        } else {
            failsafe.show(is.get() ? Kind.ALARM : Kind.GOOD, TEXTS.get(is.get() ? "failsafe.yes" : "failsafe.no"));
        }
    }

    private void showSatellites(Value fix, Value count) {
        if (fix instanceof Value.Unknown) {
            satellites.show(Kind.QUIET, TEXTS.get("satellites.unknown"));
        } else if (fix.toString().startsWith(NO_FIX)) {
            satellites.show(Kind.WARNING, TEXTS.get("satellites.noFix", ReadingText.of(count)));
        } else {
            satellites.show(Kind.GOOD, TEXTS.get("satellites", fix.toString(), ReadingText.of(count)));
        }
    }

    private void showLink(MajicBot bot) {
        switch (bot.connection()) {
            case NEW, CONNECTING -> link.show(Kind.QUIET, TEXTS.get("link.connecting"));
            case LOST, CLOSED -> link.show(Kind.ALARM, TEXTS.get("link.lost"));
            case CONNECTED -> showAge(value(bot, "age"));
        }
    }

    private void showAge(Value age) {
        if (!(age instanceof Value.Number ms)) {
            link.show(Kind.WARNING, TEXTS.get("link.noReport"));
        } else if (ms.amount() > MS_PER_S * SILENT_S) {
            link.show(
                    Kind.WARNING, TEXTS.get("link.silent", String.format(Locale.ROOT, "%.1f", ms.amount() / MS_PER_S)));
        } else {
            link.show(Kind.GOOD, TEXTS.get("link.good"));
        }
    }
}
