package majic.hemisson.panel;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Collectors;
import javax.swing.JLabel;
import majic.bot.Pose;
import majic.hemisson.line.LinkQuality;
import majic.hemisson.readings.Clearance;
import majic.hemisson.readings.Proximity;
import majic.panel.NumbersPanel;

/**
 * A Hemisson's readings in figures; what moves is an estimate, for the robot measures nothing of it. For the event
 * thread.
 */
final class HemissonNumbers extends NumbersPanel {
    private static final long serialVersionUID = 1;
    private static final String NONE = "–";
    private static final double SHORT_MS = 0.1;
    private static final String LONGEST = "≈ -888 deg/s";

    private final JLabel wheels = row("wheels", LONGEST);
    private final JLabel speed = row("speed", LONGEST);
    private final JLabel turnRate = row("turnRate", LONGEST);
    private final JLabel front = row("distanceFront", LONGEST);
    private final JLabel left = row("distanceLeft", LONGEST);
    private final JLabel right = row("distanceRight", LONGEST);
    private final JLabel back = row("distanceBack", LONGEST);
    private final JLabel x = row("x", LONGEST);
    private final JLabel y = row("y", LONGEST);
    private final JLabel heading = row("heading", LONGEST);
    private final JLabel switches = row("switches", LONGEST);
    private final JLabel beep = row("beep", "off");
    private final JLabel roundTrip = row("round trip", LONGEST);
    private final JLabel missed = row("missed", LONGEST);
    private final JLabel repeated = row("repeated", LONGEST);

    void show(HemissonView view) {
        wheels.setText(view.wheels().left() + ", " + view.wheels().right());
        beep.setText(view.buzzing() ? "on" : "off");
        switches.setText(
                view.switches().isEmpty()
                        ? NONE
                        : view.switches().stream().map(String::valueOf).collect(Collectors.joining(", ")));
        showDistances(view);
        showMotion(view);
        LinkQuality quality = view.line().quality();
        roundTrip.setText(milliseconds("", quality));
        missed.setText(text("%d of %d", quality.misses(), quality.misses() + quality.answers()));
        repeated.setText(text("%d", quality.repeats()));
    }

    private void showDistances(HemissonView view) {
        front.setText(distance(view, Clearance::front));
        left.setText(distance(view, Clearance::left));
        right.setText(distance(view, Clearance::right));
        back.setText(distance(view, Clearance::back));
    }

    private static String distance(HemissonView view, Function<Proximity, OptionalDouble> from) {
        Proximity seen = view.seen();
        if (seen == null) {
            return NONE;
        }
        OptionalDouble mm = from.apply(seen);
        return mm.isPresent() ? text("≈ %.0f mm", mm.getAsDouble()) : "clear";
    }

    private void showMotion(HemissonView view) {
        speed.setText(text("≈ %.0f mm/s", view.state().speedMmPerSec()));
        turnRate.setText(text("≈ %.0f deg/s", view.state().turnRateDegPerSec()));
        Pose pose = view.state().pose();
        x.setText(text("≈ %.0f mm", pose.xMm()));
        y.setText(text("≈ %.0f mm", pose.yMm()));
        heading.setText(text("≈ %.0f deg", pose.headingDeg()));
    }

    /** The mean round trip, with a digit behind the point where it matters. */
    static String milliseconds(String name, LinkQuality quality) {
        double ms = quality.roundTripMs();
        String format = ms < SHORT_MS ? "%s < %.1f ms" : ms < 10 ? "%s %.1f ms" : "%s %.0f ms";
        return text(format, name, Math.max(SHORT_MS, ms)).strip();
    }

    private static String text(String format, Object... numbers) {
        return String.format(Locale.ROOT, format, numbers);
    }
}
