package majic.pioneer;

import java.awt.BorderLayout;
import java.awt.GridLayout;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.bot.MajicBot;
import org.jspecify.annotations.Nullable;

/** A Pioneer's pose, speeds, battery and lights in words and numbers. For the event thread. */
final class PioneerNumbers extends JPanel {
    private static final long serialVersionUID = 1;

    private final JPanel rows = new JPanel(new GridLayout(0, 2, 12, 4));
    private final JLabel position = row("Position");
    private final JLabel heading = row("Heading");
    private final JLabel speed = row("Speed");
    private final JLabel turnRate = row("Turn rate");
    private final JLabel battery = row("Battery");
    private final JLabel motors = row("Motors");
    private final JLabel contact = row("Contact");
    private final JLabel front = row("Free ahead");
    private final JLabel link = row("Link");

    PioneerNumbers() {
        super(new BorderLayout());
        setBorder(BorderFactory.createEmptyBorder(12, 0, 12, 12));
        add(rows, BorderLayout.NORTH);
    }

    private JLabel row(String title) {
        JLabel value = new JLabel("–");
        value.setName(title);
        rows.add(new JLabel(title));
        rows.add(value);
        return value;
    }

    void show(PioneerState state, MajicBot.Connection connection) {
        position.setText(text("%.0f, %.0f mm", state.pose().xMm(), state.pose().yMm()));
        heading.setText(text("%.1f deg", state.pose().headingDeg()));
        speed.setText(text("%.0f mm/s", state.speedMmPerSec()));
        turnRate.setText(text("%.0f deg/s", state.turnRateDegPerSec()));
        battery.setText(text("%.1f V", state.volts()));
        motors.setText(state.stopButton() ? "STOP pressed" : state.motorsOn() ? "on" : "off");
        contact.setText(contact(state));
        front.setText(gap(state.gaps().get(Side.FRONT)));
        link.setText(
                connection == MajicBot.Connection.CONNECTED
                        ? text("%.0f packets/s", state.sipsPerSec())
                        : connection.name().toLowerCase(Locale.ROOT));
    }

    private static String contact(PioneerState state) {
        if (state.stalled()) {
            return state.stallLeft() && state.stallRight()
                    ? "stalled"
                    : state.stallLeft() ? "stalled left" : "stalled right";
        }
        return "none";
    }

    private static String gap(@Nullable Double mm) {
        if (mm == null) {
            return "unknown";
        }
        return mm.isInfinite() ? "clear" : text("%.0f mm", mm);
    }

    private static String text(String format, Object... numbers) {
        return String.format(Locale.ROOT, format, numbers);
    }
}
