package majic.pioneer.panel;

import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.panel.BatteryIcon;
import majic.panel.Gauge;
import majic.panel.PlotLink;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Power;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Speed, turn rate and battery of a Pioneer. For the event thread. */
final class GaugesPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private static final Texts TEXTS = Texts.of(GaugesPanel.class);

    private final Gauge speed = new Gauge("speed", "mm/s", false).labelled(TEXTS.get("speed"));
    private final Gauge turnRate = new Gauge("turnRate", "°/s", true).labelled(TEXTS.get("turnRate"));
    private final JLabel battery =
            new JLabel(TEXTS.get("battery.none"), new BatteryIcon(OptionalInt.empty(), false), JLabel.LEADING);

    GaugesPanel() {
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
        boolean charging = power.charging().isCharging();
        battery.setText(charging ? TEXTS.get("battery.charging", charge(power)) : charge(power));
        battery.setIcon(new BatteryIcon(power.percent(), charging));
        battery.setDisabledIcon(new BatteryIcon(OptionalInt.empty(), false));
        battery.setToolTipText(tip(power));
    }

    private static String charge(Power power) {
        String volts = String.format(Locale.ROOT, "%.1f", power.volts());
        OptionalInt percent = power.percent();
        return percent.isPresent()
                ? TEXTS.get("battery.percent", volts, percent.getAsInt())
                : TEXTS.get("battery", volts);
    }

    private static String tip(Power power) {
        boolean known = power.percent().isPresent();
        return TEXTS.get(
                known ? "battery.tip" : "battery.noCharge", power.charging().words());
    }
}
