package majic.pioneer.panel;

import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.panel.BatteryIcon;
import majic.panel.Gauge;
import majic.panel.PlotLink;
import majic.panel.ReadingText;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Power;
import net.miginfocom.swing.MigLayout;

/** Speed, turn rate and battery of a Pioneer. For the event thread. */
final class GaugesPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private final Gauge speed = new Gauge("speed", "mm/s", false);
    private final Gauge turnRate = new Gauge("turnRate", "°/s", true);
    private final JLabel battery =
            new JLabel("no reading yet", new BatteryIcon(OptionalInt.empty(), false), JLabel.LEADING);

    GaugesPanel() {
        super(new MigLayout("insets 0, wrap 1, fillx, gap 0 2, novisualpadding", "[grow, fill]"));
        setOpaque(false);
        speed.setToolTipText(
                "From the wheels, ahead positive; the ends are the speed limits. " + ReadingText.tip("speed"));
        turnRate.setToolTipText(
                "To the left positive; the ends are the limits of the turn rate. " + ReadingText.tip("turnRate"));
        battery.setName("battery");
        battery.setFocusable(true);
        PlotLink.install(battery, List.of("voltage", "battery"));
        add(speed);
        add(turnRate);
        add(battery);
    }

    void show(PioneerScene scene) {
        PioneerState state = scene.state();
        speed.setEnabled(scene.isConnected());
        speed.show(state.speedMmPerSec(), scene.speedLimits());
        turnRate.setEnabled(scene.isConnected());
        turnRate.show(state.turnRateDegPerSec(), scene.turnLimits());
        battery.setEnabled(scene.isConnected());
        showBattery(state.power());
    }

    private void showBattery(Power power) {
        String percent = power.percent().isPresent() ? ", " + power.percent().getAsInt() + " %" : "";
        boolean charging = power.charging().isCharging();
        battery.setText(String.format(Locale.ROOT, "%.1f V%s%s", power.volts(), percent, charging ? ", charging" : ""));
        battery.setIcon(new BatteryIcon(power.percent(), charging));
        battery.setDisabledIcon(new BatteryIcon(OptionalInt.empty(), false));
        battery.setToolTipText(tip(power));
    }

    private static String tip(Power power) {
        String charge = power.percent().isPresent() ? "" : "; this robot does not report its charge";
        return "The battery, charger: " + power.charging().words() + charge;
    }
}
