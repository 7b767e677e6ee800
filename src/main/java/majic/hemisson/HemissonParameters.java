package majic.hemisson;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import majic.bot.Parameter;
import majic.bot.ParameterTable;
import majic.bot.Unit;
import majic.bot.Value;
import majic.bot.Value.Flag.Words;

/** What can be read from and set on a Hemisson. */
final class HemissonParameters {
    private static final List<String> NAMES =
            List.of("front", "front right", "front left", "right", "left", "rear", "ground right", "ground left");

    private final ParameterTable table;
    private final MajicHemisson bot;

    private HemissonParameters(ParameterTable table, MajicHemisson bot) {
        this.table = table;
        this.bot = bot;
    }

    static void describe(ParameterTable table, MajicHemisson bot) {
        HemissonParameters parameters = new HemissonParameters(table, bot);
        parameters.describeDistances();
        parameters.describeProximity();
        parameters.describeLight();
        parameters.describeLamps();
        parameters.describeWheels();
        parameters.describeRobot();
        parameters.describeWhatItLacks();
    }

    private void describeDistances() {
        distance(
                "distanceFront",
                "free way ahead by five infra-red sensors; dark things seem farther",
                Clearance::front);
        distance("distanceLeft", "from the hull to the left, up to 50 mm; dark things seem farther", Clearance::left);
        distance(
                "distanceRight", "from the hull to the right, up to 50 mm; dark things seem farther", Clearance::right);
        distance("distanceBack", "from the hull backward, up to 60 mm; dark things seem farther", Clearance::back);
    }

    private void distance(String name, String help, Function<Proximity, OptionalDouble> from) {
        table.add(Parameter.number(name, Unit.MM, help), fromSeen(seen -> {
            OptionalDouble mm = from.apply(seen);
            return mm.isPresent() ? Value.about(mm.getAsDouble(), Unit.MM) : Value.CLEAR;
        }));
    }

    private void describeProximity() {
        String order = "0 nothing to 255 near: " + String.join(", ", NAMES);
        table.add(
                Parameter.list("prox", Unit.NONE, order),
                fromSeen(seen -> Value.many(
                        seen.raw().stream().map(HemissonParameters::count).toList())));
        for (int sensor = 0; sensor < Proximity.SENSORS; sensor++) {
            int index = sensor;
            table.add(
                    Parameter.number("prox" + sensor, Unit.NONE, "0 nothing to 255 near, " + NAMES.get(sensor)),
                    fromSeen(seen -> count(seen.value(index))));
        }
        table.add(
                Parameter.number("groundRight", Unit.NONE, "what the ground reflects on the right, large when white"),
                fromSeen(seen -> count(seen.value(Proximity.GROUND_RIGHT))));
        table.add(
                Parameter.number("groundLeft", Unit.NONE, "what the ground reflects on the left, large when white"),
                this::groundLeft);
    }

    private Value groundLeft() {
        List<Integer> light = bot.ask(Question.LIGHT).numbers();
        return fromSeen(seen -> count(Proximity.correctedGroundLeft(
                        seen.value(Proximity.GROUND_LEFT),
                        light.get(Proximity.GROUND_RIGHT),
                        light.get(Proximity.GROUND_LEFT))))
                .get();
    }

    private void describeLight() {
        table.add(
                Parameter.list(
                        "lightSensors", Unit.NONE, "0 bright to 255 dark (infra-red): " + String.join(", ", NAMES)),
                () -> Value.many(bot.ask(Question.LIGHT).numbers().stream()
                        .map(HemissonParameters::count)
                        .toList()));
        for (int sensor = 0; sensor < Proximity.SENSORS; sensor++) {
            int index = sensor;
            table.add(
                    Parameter.number("light" + sensor, Unit.NONE, "0 bright to 255 dark, " + NAMES.get(sensor)),
                    () -> count(bot.ask(Question.LIGHT).numbers().get(index)));
        }
    }

    private void describeLamps() {
        lamp(
                "light",
                "both front lamps",
                leds -> leds.left() && leds.right(),
                (leds, on) -> leds.withLeft(on).withRight(on));
        lamp("ledLeft", "front left lamp", Leds::left, Leds::withLeft);
        lamp("ledRight", "front right lamp", Leds::right, Leds::withRight);
        lamp("ledOnOff", "the On/Off lamp; the robot takes it back within half a second", Leds::onOff, Leds::withOnOff);
        lamp("ledPgm", "the Pgm/Exec lamp", Leds::pgm, Leds::withPgm);
        table.add(
                        Parameter.onOff("beep", "the buzzer, until it is switched off"),
                        () -> onOff(bot.lamps().isBuzzing()))
                .writes(values -> bot.lamps().buzz(values.get(0).isYes()));
    }

    private void lamp(
            String name, String help, Function<Leds, Boolean> reader, BiFunction<Leds, Boolean, Leds> writer) {
        table.add(
                        Parameter.onOff(name, help),
                        () -> onOff(reader.apply(bot.lamps().leds())))
                .writes(values -> {
                    boolean on = values.get(0).isYes();
                    UnaryOperator<Leds> change = leds -> writer.apply(leds, on);
                    bot.lamps().light(change);
                });
    }

    private void describeWheels() {
        table.add(
                Parameter.number("speedLeft", Unit.NONE, "what the left motor is set to, -9 to 9; not measured"),
                () -> count(bot.ask(Question.SPEEDS).numbers().get(0)));
        table.add(
                Parameter.number("speedRight", Unit.NONE, "what the right motor is set to, -9 to 9; not measured"),
                () -> count(bot.ask(Question.SPEEDS).numbers().get(1)));
        table.add(
                        Parameter.number("wheelDistance", Unit.MM, "from wheel to wheel; calibrates turns")
                                .within(30, 300),
                        () -> Value.of(bot.speeds().wheelDistanceMm(), Unit.MM))
                .writes(values -> bot.recalibrate(
                        calibration -> calibration.wheelDistance(values.get(0).number())));
        table.add(
                        Parameter.number("speedScale", Unit.NONE, "its speeds against the manual's; calibrates moves")
                                .within(0.2, 3),
                        () -> Value.of(bot.speeds().scale(), Unit.NONE))
                .writes(values -> bot.recalibrate(
                        calibration -> calibration.speedScale(values.get(0).number())));
    }

    private void describeRobot() {
        table.add(
                Parameter.list("switches", Unit.NONE, "the four switches on top; 1, 1, 1, 1 is remote control"),
                () -> Value.many(bot.ask(Question.SWITCHES).numbers().stream()
                        .map(HemissonParameters::count)
                        .toList()));
        table.add(
                Parameter.text("version", "the firmware"),
                () -> bot.identity() == Identity.NOBODY
                        ? Value.unknown("not connected yet")
                        : Value.text(bot.identity().version()));
    }

    private void describeWhatItLacks() {
        String noBattery = "no command of the Hemisson tells it";
        table.add(
                Parameter.number("battery", Unit.PERCENT, "cannot be told by a Hemisson"),
                () -> Value.unknown(noBattery));
        table.add(Parameter.number("voltage", Unit.V, "cannot be told by a Hemisson"), () -> Value.unknown(noBattery));
        table.add(
                Parameter.number("odometer", Unit.MM, "cannot be told by a Hemisson"),
                () -> Value.unknown("the Hemisson has no wheel encoders; x, y and heading are estimates"));
    }

    private Supplier<Value> fromSeen(Function<Proximity, Value> reader) {
        return () -> {
            Proximity seen = bot.overseer().seen();
            return seen == null ? Value.unknown("no reading yet") : reader.apply(seen);
        };
    }

    private static Value count(int number) {
        return Value.of(number, Unit.NONE);
    }

    private static Value onOff(boolean on) {
        return new Value.Flag(on, Words.ON_OFF);
    }
}
