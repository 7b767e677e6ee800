package majic.pioneer.panel;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.JLabel;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Value;
import majic.panel.NumbersPanel;

/** A Pioneer's readings by the names of their parameters; none of them asks the robot. For the event thread. */
final class PioneerNumbers extends NumbersPanel {
    private static final long serialVersionUID = 1;
    private static final String NONE = "–";
    private static final String LONGEST = "-88888.8 mm";

    private static final List<String> SHOWN = List.of(
            "distanceFront",
            "distanceLeft",
            "distanceRight",
            "distanceBack",
            "x",
            "y",
            "heading",
            "packetRate",
            "model",
            "robotName",
            "firmware");

    private final transient Map<String, JLabel> shown = new LinkedHashMap<>();

    PioneerNumbers() {
        SHOWN.forEach(name -> shown.put(name, row(name, LONGEST)));
    }

    void show(MajicBot bot) {
        shown.forEach((name, label) -> label.setText(text(bot, name)));
    }

    /** Not every model can tell everything: one that is not known has no distances. */
    private static String text(MajicBot bot, String name) {
        try {
            Value value = bot.get(name);
            return value instanceof Value.Unknown ? NONE : value.toString();
        } catch (BotException e) {
            return NONE;
        }
    }
}
