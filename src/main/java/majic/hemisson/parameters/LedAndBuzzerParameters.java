package majic.hemisson.parameters;

import java.util.function.BiFunction;
import java.util.function.Function;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.hemisson.line.Leds;
import majic.hemisson.modules.Modules;

/** The four LEDs and the buzzer. */
final class LedAndBuzzerParameters implements ParameterTheme<Modules> {
    private final LedsAndBuzzer leds;

    LedAndBuzzerParameters(LedsAndBuzzer leds) {
        this.leds = leds;
    }

    @Override
    public void describe(ParameterTable table, Modules modules) {
        led(
                table,
                "light",
                "both front LEDs",
                now -> now.left() && now.right(),
                (now, on) -> now.withLeft(on).withRight(on));
        led(table, "ledLeft", "front left LED", Leds::left, Leds::withLeft);
        led(table, "ledRight", "front right LED", Leds::right, Leds::withRight);
        led(table, "ledPgm", "the Pgm/Exec LED", Leds::pgm, Leds::withPgm);
        led(
                table,
                "ledOnOff",
                "the On/Off LED; the robot takes it back within half a second",
                Leds::onOff,
                Leds::withOnOff);
        buzzer(table, "beep", "the buzzer, until it is switched off");
        buzzer(table, "buzzer", "the same as beep");
    }

    private void led(
            ParameterTable table,
            String name,
            String help,
            Function<Leds, Boolean> reader,
            BiFunction<Leds, Boolean, Leds> writer) {
        table.add(Parameter.onOff(name, help), () -> Value.onOff(reader.apply(leds.leds())))
                .writes(values -> {
                    boolean on = values.get(0).isYes();
                    leds.light(now -> writer.apply(now, on));
                });
    }

    private void buzzer(ParameterTable table, String name, String help) {
        table.add(Parameter.onOff(name, help), () -> Value.onOff(leds.isBuzzing()))
                .writes(values -> leds.buzz(values.get(0).isYes()));
    }
}
