package majic.hemisson.parameters;

import java.util.function.BiFunction;
import java.util.function.Function;
import majic.bot.Parameter;
import majic.bot.ParameterTable;
import majic.bot.Value;
import majic.driver.ParameterTheme;
import majic.hemisson.line.Leds;
import majic.hemisson.modules.Modules;

/** The four LEDs and the buzzer. */
final class LedAndBuzzerParameters implements ParameterTheme<Modules> {
    private final LedsAndBuzzer lamps;

    LedAndBuzzerParameters(LedsAndBuzzer lamps) {
        this.lamps = lamps;
    }

    @Override
    public void describe(ParameterTable table, Modules modules) {
        lamp(
                table,
                "light",
                "both front lamps",
                leds -> leds.left() && leds.right(),
                (leds, on) -> leds.withLeft(on).withRight(on));
        lamp(table, "ledLeft", "front left lamp", Leds::left, Leds::withLeft);
        lamp(table, "ledRight", "front right lamp", Leds::right, Leds::withRight);
        lamp(table, "ledPgm", "the Pgm/Exec lamp", Leds::pgm, Leds::withPgm);
        lamp(
                table,
                "ledOnOff",
                "the On/Off lamp; the robot takes it back within half a second",
                Leds::onOff,
                Leds::withOnOff);
        buzzer(table, "beep", "the buzzer, until it is switched off");
        buzzer(table, "buzzer", "the same as beep");
    }

    private void lamp(
            ParameterTable table,
            String name,
            String help,
            Function<Leds, Boolean> reader,
            BiFunction<Leds, Boolean, Leds> writer) {
        table.add(Parameter.onOff(name, help), () -> Value.onOff(reader.apply(lamps.leds())))
                .writes(values -> {
                    boolean on = values.get(0).isYes();
                    lamps.light(leds -> writer.apply(leds, on));
                });
    }

    private void buzzer(ParameterTable table, String name, String help) {
        table.add(Parameter.onOff(name, help), () -> Value.onOff(lamps.isBuzzing()))
                .writes(values -> lamps.buzz(values.get(0).isYes()));
    }
}
