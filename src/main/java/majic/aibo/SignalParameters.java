package majic.aibo;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import majic.bot.Parameter;
import majic.bot.ParameterTable;
import majic.bot.Unit;
import majic.bot.Value;

/** What shows or sounds: the face's LEDs and the speaker. None of it moves the dog. */
final class SignalParameters {
    private static final int FACE_LEDS = 14;
    private static final double ASK_S = 2;

    private final Supplier<AiboSession> session;
    private volatile List<Double> former = List.of();
    private volatile boolean lit;

    SignalParameters(Supplier<AiboSession> session) {
        this.session = session;
    }

    void describe(ParameterTable table) {
        table.add(
                        Parameter.number("ledF", Unit.NONE, "brightness of all face LEDs")
                                .within(0, 1),
                        () -> Value.of(brightness(1), Unit.NONE))
                .writes(values -> send("ledF = " + Dialect.number(values.get(0).number())));
        table.add(Parameter.onOff("light", "lights the face, to find out which robot this is"), () -> Value.onOff(lit))
                .writes(values -> light(values.get(0).isYes()));
        table.add(Parameter.onOff("beep", "on beeps once"), () -> Value.onOff(false))
                .writes(values -> beep(values.get(0).isYes()));
    }

    private void beep(boolean on) {
        if (on) {
            send("speaker.play(\"beep.wav\")");
        }
    }

    /** Lights the whole face; off gives each LED back what it showed before. */
    private void light(boolean on) {
        if (on == lit) {
            return;
        }
        if (on) {
            former = IntStream.rangeClosed(1, FACE_LEDS)
                    .mapToObj(this::brightness)
                    .toList();
            send("ledF = 1");
        } else {
            giveBack();
        }
        lit = on;
    }

    private void giveBack() {
        List<Double> before = former;
        send(IntStream.rangeClosed(1, before.size())
                .mapToObj(led -> "ledF" + led + ".val = " + Dialect.number(before.get(led - 1)))
                .collect(Collectors.joining(" & ")));
    }

    private double brightness(int led) {
        AiboSession open = session.get();
        UrbiValue value = open.ask(open.links().sensors(), "ledF" + led + ".val", ASK_S);
        return value instanceof UrbiValue.Num number && Double.isFinite(number.amount()) ? number.amount() : 0;
    }

    private void send(String command) {
        session.get().links().sensors().send(command + ",");
    }
}
