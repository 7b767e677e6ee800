package majic.hemisson.panel;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Collectors;
import majic.bot.Value;
import majic.hemisson.line.LinkQuality;
import majic.hemisson.readings.Clearance;
import majic.hemisson.readings.Proximity;
import majic.panel.ReadingText;
import majic.panel.ReadingsPanel;
import majic.text.NumberText;
import majic.text.Texts;

/** A Hemisson's readings as text; motion and pose are estimates ("≈"), because the robot does not measure them. */
final class HemissonReadings {
    private static final double SHORT_MS = 0.1;
    private static final Texts TEXTS = Texts.of(HemissonReadings.class);
    private static final String LONGEST = "≈ -888 °/s";

    private HemissonReadings() {}

    static ReadingsPanel<HemissonScene> panel() {
        return new ReadingsPanel<HemissonScene>(LONGEST)
                .with(
                        "wheels",
                        HemissonDrawing.WHEELS,
                        view -> NumberText.of(
                                view.wheels().left() + ", " + view.wheels().right()))
                .with("speed", view -> about("mm/s", view.state().speedMmPerSec()))
                .with("turnRate", view -> about("deg/s", view.state().turnRateDegPerSec()))
                .with("distanceFront", view -> distance(view, Clearance::front))
                .with("distanceLeft", view -> distance(view, Clearance::left))
                .with("distanceRight", view -> distance(view, Clearance::right))
                .with("distanceBack", view -> distance(view, Clearance::back))
                .with("x", view -> about("mm", view.state().pose().xMm()))
                .with("y", view -> about("mm", view.state().pose().yMm()))
                .with("heading", view -> about("deg", view.state().pose().headingDeg()))
                .with("switches", HemissonReadings::switches)
                .with("beep", view -> ReadingText.of(Value.onOff(view.buzzing())))
                .with("roundTrip", view -> roundTrip(view.line().quality()))
                .with("missedAnswers", view -> missed(view.line().quality()))
                .with("repeated", view -> String.valueOf(view.line().quality().repeats()))
                .labelled(TEXTS::get);
    }

    private static String distance(HemissonScene view, Function<Proximity, OptionalDouble> from) {
        Proximity seen = view.seen();
        if (seen == null) {
            return ReadingsPanel.NONE;
        }
        OptionalDouble mm = from.apply(seen);
        return mm.isPresent() ? about("mm", mm.getAsDouble()) : ReadingText.of(Value.CLEAR);
    }

    private static String switches(HemissonScene view) {
        return view.switches().isEmpty()
                ? ReadingsPanel.NONE
                : view.switches().stream().map(String::valueOf).collect(Collectors.joining(", "));
    }

    private static String missed(LinkQuality quality) {
        return TEXTS.get("missed", quality.misses(), quality.misses() + quality.answers());
    }

    private static String about(String unit, double amount) {
        return ReadingText.degrees(NumberText.of(text("≈ %.0f %s", amount, unit)));
    }

    /** The mean round trip, with a decimal place below 10 ms. */
    static String roundTrip(LinkQuality quality) {
        double ms = quality.roundTripMs();
        String format = ms < SHORT_MS ? "< %.1f ms" : ms < 10 ? "%.1f ms" : "%.0f ms";
        return text(format, Math.max(SHORT_MS, ms));
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
