package majic.aibo.panel;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.aibo.body.BodyTilt;
import majic.aibo.body.Sensor;
import majic.aibo.body.SensorReadings;
import majic.panel.BatteryIcon;
import majic.panel.Horizon;
import majic.panel.PlotLink;
import majic.panel.StatusLight;
import majic.panel.StatusLight.Kind;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** How the dog lies in space, its battery, its posture and its motors. For the event thread. */
final class BodyPanel extends JPanel {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(BodyPanel.class);
    private static final int DISC = 56;

    /** The keys of the words for what the dog reports. */
    private static final Map<String, String> POSTURES = Map.of(
            "stand", "posture.stand",
            "sit", "posture.sit",
            "lay", "posture.lay",
            "beg", "posture.beg",
            "stretch", "posture.stretch");

    private final Horizon horizon = new Horizon(DISC);
    private final JLabel battery =
            new JLabel(TEXTS.get("battery.none"), new BatteryIcon(OptionalInt.empty(), false), JLabel.LEADING);
    private final JLabel posture = new JLabel("–");
    private final StatusLight motors = new StatusLight("motorsLight", TEXTS.get("motors.tip"));

    BodyPanel() {
        super(new MigLayout("insets 0, gap 8 0, novisualpadding", "[][grow, fill]", "[][][]"));
        setOpaque(false);
        battery.setName("batteryLeft");
        battery.setDisabledIcon(new BatteryIcon(OptionalInt.empty(), false));
        battery.setFocusable(true);
        PlotLink.install(battery, List.of("battery"));
        battery.setToolTipText(TEXTS.get("battery.tip"));
        posture.setName("postureGuess");
        posture.setToolTipText(TEXTS.get("posture.tip"));
        add(horizon, "span 1 3");
        add(battery, "wrap");
        add(motors, "wrap");
        add(posture);
    }

    /** Returns the user's word for a posture; a word of the dog that has none is shown as it is. */
    private static String word(String guess) {
        String key = POSTURES.get(guess);
        return key == null ? guess : TEXTS.get(key);
    }

    void refresh(SensorReadings senses, boolean connected) {
        horizon.setEnabled(connected);
        horizon.show(BodyTilt.of(senses)
                .map(now -> new Horizon.Tilt(now.pitchDeg(), now.rollDeg()))
                .orElse(null));
        battery.setEnabled(connected);
        posture.setEnabled(connected);
        motors.setEnabled(connected);
        String guess = senses.posture();
        posture.setText(guess == null ? TEXTS.get("posture.unknown") : TEXTS.get("posture", word(guess)));
        Optional<Boolean> on = senses.motorsOn();
        motors.show(
                on.orElse(false) ? Kind.GOOD : Kind.QUIET,
                on.map(BodyPanel::words).orElseGet(() -> TEXTS.get("motors.unknown")));
        showBattery(senses.number(Sensor.CHARGE));
    }

    private static String words(boolean on) {
        return on ? TEXTS.get("motors.on") : TEXTS.get("motors.off");
    }

    private void showBattery(Optional<Double> charge) {
        OptionalInt percent =
                charge.isPresent() ? OptionalInt.of((int) Math.round(100 * charge.get())) : OptionalInt.empty();
        BatteryIcon icon = new BatteryIcon(percent, false);
        if (!icon.equals(battery.getIcon())) {
            battery.setIcon(icon);
        }
        battery.setText(percent.isPresent() ? percent.getAsInt() + " %" : TEXTS.get("battery.none"));
    }
}
