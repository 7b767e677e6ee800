package majic.panel;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.bot.Range;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Shows speed, turn rate and battery of a robot with wheels. Must be used on the event dispatch thread. */
public final class DriveGauges extends JPanel {
    private static final long serialVersionUID = 1;

    private static final Texts TEXTS = Texts.of(DriveGauges.class);

    private final Gauge speed = new Gauge("speed", "mm/s", false).labelled(TEXTS.get("speed"));
    private final Gauge turnRate = new Gauge("turnRate", "°/s", true).labelled(TEXTS.get("turnRate"));
    private final JLabel battery =
            new JLabel(TEXTS.get("battery.none"), new BatteryIcon(OptionalInt.empty(), false), JLabel.LEADING);

    /** Creates gauges without readings. */
    public DriveGauges() {
        super(new MigLayout("insets 0, wrap 1, fillx, gap 0 2, novisualpadding", "[grow, fill]"));
        setOpaque(false);
        speed.setToolTipText(TEXTS.get("speed.tip"));
        turnRate.setToolTipText(TEXTS.get("turnRate.tip"));
        battery.setName("battery");
        battery.setFocusable(true);
        PlotLink.install(battery, List.of("voltage", "battery"));
        add(speed);
        add(turnRate);
        add(battery);
    }

    /**
     * Shows whether the values are current; older ones are greyed.
     *
     * @param current whether they are current
     */
    public void setCurrent(boolean current) {
        speed.setEnabled(current);
        turnRate.setEnabled(current);
        battery.setEnabled(current);
    }

    /**
     * Shows how the robot moves.
     *
     * @param mmPerSec ahead positive
     * @param speedLimits mm/s, both signs
     * @param degPerSec to the left positive
     * @param turnLimits deg/s, both signs
     */
    public void showMotion(double mmPerSec, Range speedLimits, double degPerSec, Range turnLimits) {
        speed.show(mmPerSec, speedLimits);
        turnRate.show(degPerSec, turnLimits);
    }

    /**
     * Shows the battery.
     *
     * @param volts empty if unknown
     * @param percent of the charge; empty if unknown
     * @param charging whether it is being charged
     * @param charger what the charger does, in words
     */
    public void showBattery(OptionalDouble volts, OptionalInt percent, boolean charging, String charger) {
        String charge = charge(volts, percent);
        battery.setText(charging ? TEXTS.get("battery.charging", charge) : charge);
        battery.setIcon(new BatteryIcon(percent, charging));
        battery.setDisabledIcon(new BatteryIcon(OptionalInt.empty(), false));
        battery.setToolTipText(TEXTS.get(percent.isPresent() ? "battery.tip" : "battery.noCharge", charger));
    }

    private static String charge(OptionalDouble volts, OptionalInt percent) {
        if (volts.isEmpty()) {
            return percent.isEmpty() ? TEXTS.get("battery.none") : TEXTS.get("battery.onlyPercent", percent.getAsInt());
        }
        String figure = String.format(Locale.ROOT, "%.1f", volts.getAsDouble());
        return percent.isEmpty()
                ? TEXTS.get("battery", figure)
                : TEXTS.get("battery.percent", figure, percent.getAsInt());
    }
}
