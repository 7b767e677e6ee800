package majic.mavlink.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.bot.MajicBot;
import majic.bot.Reading;
import majic.bot.Value;
import majic.panel.BatteryIcon;
import majic.panel.FoldingPane;
import majic.panel.PlotLink;
import majic.panel.ReadingsPanel;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Attitude, height, speeds, battery, lights and controls of a vehicle. For the event dispatch thread. */
final class FlightPanel extends JPanel implements FoldingPane {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(FlightPanel.class);
    private static final int GAP = 4;

    /** Sides of the compass beside the values, and above them, pixels. */
    private static final int COMPASS = 124;

    private static final int FOLDED_COMPASS = 58;
    private static final String LONGEST = "-88888 mm/s";
    private static final List<String> READINGS = List.of("altitude", "climbRate", "groundSpeed");

    private final VehicleControls controls = new VehicleControls();
    private final JPanel values =
            new JPanel(new MigLayout("insets 0, wrap 1, fillx, gap 0 2, novisualpadding", "[grow, fill]"));
    private final CompassRing compass = new CompassRing();
    private final ReadingsPanel<MajicBot> readings =
            ReadingsPanel.ofParameters(LONGEST, READINGS).labelled(TEXTS::get);
    private final transient VehicleLights lights = new VehicleLights();
    private final JLabel battery =
            new JLabel(TEXTS.get("battery.none"), new BatteryIcon(OptionalInt.empty(), false), JLabel.LEADING);

    FlightPanel() {
        super(null);
        setOpaque(false);
        battery.setName("battery");
        battery.setDisabledIcon(new BatteryIcon(OptionalInt.empty(), false));
        battery.setFocusable(true);
        battery.setToolTipText(TEXTS.get("battery.tip"));
        PlotLink.install(battery, List.of("voltage", "battery"));
        values.setOpaque(false);
        values.add(readings);
        values.add(battery);
        values.add(lights.panel());
        add(compass);
        add(values);
        add(controls);
    }

    void show(MajicBot bot, Optional<VehicleScene> scene) {
        boolean current = bot.isConnected();
        compass.show(scene.flatMap(VehicleScene::attitude), current);
        controls.show(bot, scene.map(VehicleScene::modes).orElse(List.of()));
        readings.show(bot, current);
        lights.show(bot, scene.flatMap(VehicleScene::failsafe));
        battery.setEnabled(current);
        showBattery(number(bot, "voltage"), number(bot, "battery"));
    }

    @Override
    public int foldedWidth() {
        return Math.max(values.getPreferredSize().width, controls.getMinimumSize().width);
    }

    @Override
    public int unfoldedWidth() {
        int beside = UIScale.scale(COMPASS) + 2 * UIScale.scale(GAP) + values.getPreferredSize().width;
        return Math.max(beside, controls.getMinimumSize().width);
    }

    @Override
    public int heightIn(int width) {
        int compassPx = UIScale.scale(width < unfoldedWidth() ? FOLDED_COMPASS : COMPASS);
        int valuesPx = values.getPreferredSize().height;
        int gap = UIScale.scale(GAP);
        int flight = width < unfoldedWidth() ? compassPx + gap + valuesPx : Math.max(compassPx, valuesPx);
        return flight + gap + controls.getPreferredSize().height;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(unfoldedWidth(), heightIn(unfoldedWidth()));
    }

    @Override
    public void doLayout() {
        int width = getWidth();
        int gap = UIScale.scale(GAP);
        int valuesPx = values.getPreferredSize().height;
        int controlsPx = controls.getPreferredSize().height;
        if (width < unfoldedWidth()) {
            int side = UIScale.scale(FOLDED_COMPASS);
            compass.setBounds((width - side) / 2, 0, side, side);
            values.setBounds(0, side + gap, width, valuesPx);
        } else {
            int side = UIScale.scale(COMPASS);
            int high = Math.max(side, valuesPx);
            compass.setBounds(0, (high - side) / 2, side, side);
            values.setBounds(side + 2 * gap, (high - valuesPx) / 2, width - side - 2 * gap, valuesPx);
        }
        controls.setBounds(0, heightIn(width) - controlsPx, width, controlsPx);
    }

    private static OptionalDouble number(MajicBot bot, String parameter) {
        Reading reading = bot.reading(parameter);
        Value value = bot.isConnected() ? reading.value() : reading.last();
        return value instanceof Value.Number number ? OptionalDouble.of(number.amount()) : OptionalDouble.empty();
    }

    private void showBattery(OptionalDouble volts, OptionalDouble percent) {
        OptionalInt whole =
                percent.isPresent() ? OptionalInt.of((int) Math.round(percent.getAsDouble())) : OptionalInt.empty();
        BatteryIcon icon = new BatteryIcon(whole, false);
        if (!icon.equals(battery.getIcon())) {
            battery.setIcon(icon);
        }
        battery.setText(words(volts, whole));
    }

    private static String words(OptionalDouble volts, OptionalInt percent) {
        if (volts.isEmpty()) {
            return percent.isEmpty() ? TEXTS.get("battery.none") : TEXTS.get("battery.percent", percent.getAsInt());
        }
        String figure = String.format(Locale.ROOT, "%.1f", volts.getAsDouble());
        return percent.isEmpty()
                ? TEXTS.get("battery.volts", figure)
                : TEXTS.get("battery.both", figure, percent.getAsInt());
    }
}
