package majic.aibo;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.Motion;
import majic.bot.Parameter;
import majic.bot.ParameterTable;
import majic.bot.Unit;
import majic.bot.Value;

/** The Aibo's own parameters, and the shared ones that it can have. Distances in mm, angles in degrees. */
final class AiboParameters {
    private static final double ASK_S = 4;
    private static final double PERCENT = 100;

    private final Dog dog;
    private final Senses senses;
    private final Supplier<AiboSession> session;

    AiboParameters(Dog dog, Supplier<AiboSession> session) {
        this.dog = dog;
        this.senses = dog.senses();
        this.session = session;
    }

    void describe(ParameterTable table) {
        describeDistances(table);
        new JointParameters(senses, session).describe(table);
        describeBody(table);
        describeSenses(table);
        new SignalParameters(session).describe(table);
    }

    private void describeDistances(ParameterTable table) {
        table.add(
                Parameter.number("distanceFront", Unit.MM, "the nearest thing in its way ahead, from the hull"),
                this::front);
        addRange(table, "distanceNear", Sensor.NEAR, "the near sensor in the head, 57 to 500 mm");
        addRange(table, "distance", Sensor.FAR, "the far sensor in the head, 200 to 1500 mm");
        addRange(table, "distanceFar", Sensor.FAR, "the same as distance");
        addRange(table, "distanceChest", Sensor.CHEST, "the sensor in the chest, 190 to 900 mm");
    }

    private void addRange(ParameterTable table, String name, Sensor sensor, String help) {
        table.add(Parameter.number(name, Unit.MM, help), () -> range(sensor));
    }

    private Value range(Sensor sensor) {
        if (senses.number(sensor).isEmpty()) {
            return senses.unknown(sensor);
        }
        return clearOr(dog.infraRed().rangeMm(sensor));
    }

    private Value front() {
        return dog.infraRed().isKnown() ? clearOr(dog.frontMm()) : senses.unknown(Sensor.NEAR);
    }

    private static Value clearOr(Optional<Double> mm) {
        return mm.map(distance -> Value.of(distance, Unit.MM)).orElse(Value.CLEAR);
    }

    private void describeBody(ParameterTable table) {
        table.add(
                        Parameter.choice("posture", Posture.words(), "how it stands, sits or lies"),
                        () -> Value.text(session.get().feet().posture()))
                .moves(this::take);
        table.add(
                        Parameter.yesNo("motors", "whether the legs are stiff; off lays it down first"),
                        () -> senses.motorsOn().map(Value::yesNo).orElseGet(() -> senses.unknown(Sensor.LEG_LOAD)))
                .moves(this::power);
        table.add(
                Parameter.number("battery", Unit.PERCENT, "charge left"),
                () -> senses.value(Sensor.CHARGE, PERCENT, Unit.PERCENT));
    }

    private void take(List<Value> values, Motion motion) {
        Posture posture = Posture.of(values.get(0).toString());
        session.get().feet().take(posture.function(), posture.longestS(), motion);
        session.get().sweep().home(0);
    }

    private void power(List<Value> values, Motion motion) {
        if (values.get(0).isYes()) {
            session.get().feet().power(motion);
        } else {
            session.get().feet().loosen(motion);
        }
    }

    private void describeSenses(ParameterTable table) {
        table.add(
                Parameter.yesNo("bumped", "whether something presses on its chin or head"),
                () -> senses.isAnswered(Sensor.CHIN) ? Value.yesNo(senses.isBumped()) : senses.unknown(Sensor.CHIN));
        addPlain(table, "accelX", Sensor.ACCEL_X, "acceleration from rear to front, m/s²");
        addPlain(table, "accelY", Sensor.ACCEL_Y, "acceleration from left to right, m/s²");
        addPlain(table, "accelZ", Sensor.ACCEL_Z, "acceleration upwards, m/s²; about -9.8 on its feet");
        addPlain(table, "headSensor", Sensor.HEAD_TOUCH, "pressure on the head, 0 to 35");
        addPlain(table, "backSensorF", Sensor.BACK_FRONT, "pressure on the back in front, 0 to 60");
        addPlain(table, "backSensorM", Sensor.BACK_MIDDLE, "pressure on the middle of the back, 0 to 60");
        addPlain(table, "backSensorR", Sensor.BACK_REAR, "pressure on the rear of the back, 0 to 60");
        addButton(table, "chinSensor", Sensor.CHIN, "whether the chin is pressed");
        addButton(table, "pawLF", Sensor.PAW_LF, "whether the left fore paw is on the ground");
        addButton(table, "pawRF", Sensor.PAW_RF, "whether the right fore paw is on the ground");
        addButton(table, "pawLH", Sensor.PAW_LH, "whether the left hind paw is on the ground");
        addButton(table, "pawRH", Sensor.PAW_RH, "whether the right hind paw is on the ground");
        table.add(Parameter.text("version", "the URBI in the dog"), this::version);
    }

    private void addPlain(ParameterTable table, String name, Sensor sensor, String help) {
        table.add(Parameter.number(name, Unit.NONE, help), () -> senses.value(sensor, 1, Unit.NONE));
    }

    private void addButton(ParameterTable table, String name, Sensor sensor, String help) {
        table.add(
                Parameter.yesNo(name, help),
                () -> senses.number(sensor).map(on -> Value.yesNo(on > 0)).orElseGet(() -> senses.unknown(sensor)));
    }

    private Value version() {
        AiboSession open = session.get();
        Dialect dialect = open.links().sensors().dialect();
        String urbi = dialect == Dialect.V1_5 ? "URBI 1.5" : "URBI 1.0";
        try {
            return open.ask(open.links().sensors(), "system.name", ASK_S) instanceof UrbiValue.Str name
                    ? Value.text(name.text() + ", " + urbi)
                    : Value.text(urbi);
        } catch (BotException e) {
            return Value.text(urbi);
        }
    }
}
