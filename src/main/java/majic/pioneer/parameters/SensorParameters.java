package majic.pioneer.parameters;

import java.util.Optional;
import java.util.function.ToDoubleFunction;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.state.EncoderTicks;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.RequestedReport;
import majic.pioneer.state.Scaling;

/** The motion sensors: wheels, encoders, compass, gyro. */
final class SensorParameters implements ParameterTheme<Equipment> {
    private final PioneerAccess access;

    SensorParameters(PioneerAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        Scaling scaling = equipment.model().scaling();
        wheel(table, "wheelLeft", "speed of the left wheel", state -> scaling.leftMmPerSec(state.sip()));
        wheel(table, "wheelRight", "speed of the right wheel", state -> scaling.rightMmPerSec(state.sip()));
        encoder(table, "encoderLeft", "ticks of the left wheel; requested when read", EncoderTicks::left);
        encoder(table, "encoderRight", "ticks of the right wheel; requested when read", EncoderTicks::right);
        table.add(
                Parameter.number(
                        "compass", Unit.DEG, "as the compass shows it, 2 to 358; unknown without one and at 0"),
                access.state(state -> state.compassDeg().isEmpty()
                        ? PioneerAccess.NOT_REPORTED
                        : Value.of(state.compassDeg().getAsInt(), Unit.DEG)));
        if (equipment.gyro()) {
            table.add(
                    Parameter.number("gyro", Unit.DEG_PER_S, "turn rate, left positive; requested when read"),
                    access.report(
                            RequestedReport.GYRO,
                            state -> state.gyroDegPerSec().isEmpty()
                                    ? Optional.empty()
                                    : Optional.of(Value.of(state.gyroDegPerSec().getAsDouble(), Unit.DEG_PER_S))));
        }
    }

    private void wheel(ParameterTable table, String name, String help, ToDoubleFunction<PioneerState> speed) {
        table.add(
                Parameter.number(name, Unit.MM_PER_S, help),
                access.scaled(state -> Value.of(speed.applyAsDouble(state), Unit.MM_PER_S)));
    }

    private void encoder(ParameterTable table, String name, String help, ToDoubleFunction<EncoderTicks> ticks) {
        table.add(
                Parameter.number(name, Unit.NONE, help),
                access.report(
                        RequestedReport.ENCODERS,
                        state -> state.encoders().map(counts -> Value.of(ticks.applyAsDouble(counts), Unit.NONE))));
    }
}
