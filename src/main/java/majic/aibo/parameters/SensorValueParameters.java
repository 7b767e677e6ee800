package majic.aibo.parameters;

import majic.aibo.body.Sensor;
import majic.aibo.body.SensorReadings;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;

/** The dog's touch and acceleration sensors, as it reports them. */
final class SensorValueParameters implements ParameterTheme<UrbiVersion> {
    private static final double PERCENT = 100;

    private final AiboAccess access;
    private final SensorReadings senses;

    SensorValueParameters(AiboAccess access) {
        this.access = access;
        this.senses = access.senses();
    }

    @Override
    public void describe(ParameterTable table, UrbiVersion version) {
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
