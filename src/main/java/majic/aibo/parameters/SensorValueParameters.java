package majic.aibo.parameters;

import java.util.Optional;
import majic.aibo.body.DogState;
import majic.aibo.body.Sensor;
import majic.aibo.body.SensorReadings;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;

/** What the dog's sensors report; distances in mm where the dog has cm. */
final class SensorValueParameters {
    private static final double PERCENT = 100;

    private final AiboAccess access;
    private final DogState dog;
    private final SensorReadings senses;

    SensorValueParameters(AiboAccess access, DogState dog) {
        this.access = access;
        this.dog = dog;
        this.senses = dog.senses();
    }

    /** What the infra-red beams meet. */
    void ranges(ParameterTable table, UrbiVersion version) {
        table.add(
                Parameter.number("distanceFront", Unit.MM, "from the hull to the nearest thing in its way ahead"),
                this::front);
        beam(table, "distanceNear", Sensor.NEAR, "the near sensor in the head, 57 to 500 mm");
        beam(table, "distance", Sensor.FAR, "the far sensor in the head, 200 to 1500 mm");
        beam(table, "distanceFar", Sensor.FAR, "the same as distance");
        beam(table, "distanceChest", Sensor.CHEST, "the sensor in the chest, 190 to 900 mm");
    }

    private void beam(ParameterTable table, String name, Sensor sensor, String help) {
        table.add(Parameter.number(name, Unit.MM, help), () -> range(sensor));
    }

    private Value range(Sensor sensor) {
        return senses.number(sensor).isEmpty()
                ? senses.unknown(sensor)
                : clearOr(dog.infraRed().rangeMm(sensor));
    }

    private Value front() {
        return dog.infraRed().isKnown() ? clearOr(dog.frontMm()) : senses.unknown(Sensor.NEAR);
    }

    private static Value clearOr(Optional<Double> mm) {
        return mm.map(distance -> Value.of(distance, Unit.MM)).orElse(Value.CLEAR);
    }

    /** Charge, contacts, accelerations, and the ball in the picture of the camera. */
    void others(ParameterTable table, UrbiVersion version) {
        table.add(
                Parameter.number("battery", Unit.PERCENT, "charge left"),
                () -> senses.value(Sensor.CHARGE, PERCENT, Unit.PERCENT));
        table.add(
                Parameter.yesNo("bumped", "whether something presses on its chin or head"),
                () -> senses.isAnswered(Sensor.CHIN) ? Value.yesNo(senses.isBumped()) : senses.unknown(Sensor.CHIN));
        plain(table, "accelX", Sensor.ACCEL_X, "acceleration from rear to front, m/s²");
        plain(table, "accelY", Sensor.ACCEL_Y, "acceleration from left to right, m/s²");
        plain(table, "accelZ", Sensor.ACCEL_Z, "acceleration upwards, m/s²; about -9.8 on its feet");
        plain(table, "headSensor", Sensor.HEAD_TOUCH, "pressure on the head, 0 to 35");
        plain(table, "backSensorF", Sensor.BACK_FRONT, "pressure on the back in front, 0 to 60");
        plain(table, "backSensorM", Sensor.BACK_MIDDLE, "pressure on the middle of the back, 0 to 60");
        plain(table, "backSensorR", Sensor.BACK_REAR, "pressure on the rear of the back, 0 to 60");
        button(table, "chinSensor", Sensor.CHIN, "whether the chin is pressed");
        button(table, "pawLF", Sensor.PAW_LF, "whether the left fore paw is on the ground");
        button(table, "pawRF", Sensor.PAW_RF, "whether the right fore paw is on the ground");
        button(table, "pawLH", Sensor.PAW_LH, "whether the left hind paw is on the ground");
        button(table, "pawRH", Sensor.PAW_RH, "whether the right hind paw is on the ground");
        button(table, "WIFIswitch", Sensor.WIFI_SWITCH, "whether the switch for the wireless network is on");
        describeBall(table);
    }

    private void describeBall(ParameterTable table) {
        table.add(
                Parameter.yesNo("ball", "whether the camera sees the pink ball"),
                access.asked("ball.visible", amount -> Value.yesNo(amount > 0)));
        asked(table, "ballX", "ball.x", "its horizontal place in the picture, -0.5 to 0.5");
        asked(table, "ballY", "ball.y", "its vertical place in the picture, -0.5 to 0.5");
        asked(table, "ballRatio", "ball.ratio", "how much of the picture it fills");
    }

    private void asked(ParameterTable table, String name, String expression, String help) {
        table.add(
                Parameter.number(name, Unit.NONE, help),
                access.asked(expression, amount -> Value.of(amount, Unit.NONE)));
    }

    private void plain(ParameterTable table, String name, Sensor sensor, String help) {
        table.add(Parameter.number(name, Unit.NONE, help), access.sensed(sensor, Unit.NONE));
    }

    private void button(ParameterTable table, String name, Sensor sensor, String help) {
        table.add(
                Parameter.yesNo(name, help),
                () -> senses.number(sensor).map(on -> Value.yesNo(on > 0)).orElseGet(() -> senses.unknown(sensor)));
    }
}
