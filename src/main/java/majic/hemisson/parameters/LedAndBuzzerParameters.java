package majic.hemisson.parameters;

import java.util.function.BiFunction;
import java.util.function.Function;
import majic.bot.Parameter;
import majic.bot.ParameterTable;
import majic.bot.Value;
import majic.hemisson.line.Leds;

/** The four LEDs and the buzzer. */
final class LedAndBuzzerParameters {
    private final ParameterTable table;
    private final LedsAndBuzzer lamps;

    LedAndBuzzerParameters(ParameterTable table, LedsAndBuzzer lamps) {
        this.table = table;
        this.lamps = lamps;
    }

    void describe() {
        lamp(
                "light",
                "both front lamps",
                leds -> leds.left() && leds.right(),
                (leds, on) -> leds.withLeft(on).withRight(on));
        lamp("ledLeft", "front left lamp", Leds::left, Leds::withLeft);
        lamp("ledRight", "front right lamp", Leds::right, Leds::withRight);
        lamp("ledPgm", "the Pgm/Exec lamp", Leds::pgm, Leds::withPgm);
        lamp("ledOnOff", "the On/Off lamp; the robot takes it back within half a second", Leds::onOff, Leds::withOnOff);
        buzzer("beep", "the buzzer, until it is switched off");
        buzzer("buzzer", "the same as beep");
    }

    private void lamp(
            String name, String help, Function<Leds, Boolean> reader, BiFunction<Leds, Boolean, Leds> writer) {
        table.add(Parameter.onOff(name, help), () -> Value.onOff(reader.apply(lamps.leds())))
                .writes(values -> {
                    boolean on = values.get(0).isYes();
                    lamps.light(leds -> writer.apply(leds, on));
                });
    }

    private void buzzer(String name, String help) {
        table.add(Parameter.onOff(name, help), () -> Value.onOff(lamps.isBuzzing()))
                .writes(values -> lamps.buzz(values.get(0).isYes()));
    }
}
