package majic.aibo;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.JLabel;
import majic.bot.Value;
import majic.panel.NumbersPanel;

/** A dog's readings by the names of their parameters; none of them asks the dog. For the event thread. */
final class AiboNumbers extends NumbersPanel {
    private static final long serialVersionUID = 1;
    private static final String NONE = "–";
    private static final String LONGEST = "-88888 mm";

    private static final List<String> SHOWN = List.of(
            "distanceFront",
            "distanceNear",
            "distance",
            "distanceChest",
            "bumped",
            "x",
            "y",
            "heading",
            "mouth",
            "tailPan",
            "tailTilt",
            "headSensor",
            "backSensorF",
            "backSensorM",
            "backSensorR",
            "accelX",
            "accelY",
            "accelZ");

    private final transient Map<String, JLabel> shown = new LinkedHashMap<>();

    AiboNumbers() {
        SHOWN.forEach(name -> shown.put(name, row(name, LONGEST)));
    }

    void show(MajicAibo bot) {
        shown.forEach((name, label) -> {
            label.setText(text(bot.get(name)));
            label.setEnabled(bot.isConnected());
        });
    }

    /** Short: without the word about, without the reason why there is none. */
    static String text(Value value) {
        if (value instanceof Value.Unknown) {
            return NONE;
        }
        return value instanceof Value.Number number
                ? Value.of(number.amount(), number.unit()).toString()
                : value.toString();
    }
}
