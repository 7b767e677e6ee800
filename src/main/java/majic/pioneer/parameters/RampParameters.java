package majic.pioneer.parameters;

import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.Limits;
import majic.pioneer.state.Ramps;

/** The motors: their highest speeds, accelerations and decelerations, which hold for all motions, and their power. */
public final class RampParameters implements ParameterTheme<Equipment> {
    private final PioneerAccess access;
    private final Consumer<UnaryOperator<Ramps>> change;

    /**
     * Creates the parameters of one robot.
     *
     * @param access to the session, which has the ramps in force
     * @param change puts other ramps in force
     */
    public RampParameters(PioneerAccess access, Consumer<UnaryOperator<Ramps>> change) {
        this.access = access;
        this.change = change;
    }

    /** One of the values of the ramps. */
    private interface Part {
        int of(Ramps ramps);
    }

    /** The ramps with one of their values changed. */
    private interface Changed {
        Ramps by(Ramps ramps, int value);
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        Limits limits = equipment.limits();
        add(
                table,
                Parameter.number("topSpeed", Unit.MM_PER_S, "nothing drives it faster; cruise and drive stay below")
                        .within(1, limits.speedMmPerSec()),
                Ramps::topSpeedMmPerSec,
                Ramps::withTopSpeed);
        add(
                table,
                Parameter.number("topTurn", Unit.DEG_PER_S, "nothing turns it faster; cruiseTurn and drive stay below")
                        .within(1, limits.turnDegPerSec()),
                Ramps::topTurnDegPerSec,
                Ramps::withTopTurn);
        addRamps(table, limits);
        table.add(
                        Parameter.yesNo("motors", "whether the motors are on"),
                        access.state(state -> Value.yesNo(state.motorsOn())))
                .writes(values -> power(values.get(0).isYes()));
    }

    private void power(boolean on) {
        if (on) {
            access.open().motors().announceOn();
        }
        access.sendAndConfirm(
                ArcosCommand.ENABLE.packet(on ? 1 : 0),
                state -> state.motorsOn() == on,
                "the motors " + PioneerAccess.didNotSwitch(on));
    }

    private void addRamps(ParameterTable table, Limits limits) {
        Parameter straight = Parameter.number("acceleration", Unit.MM_PER_S2, "how sharply it speeds up")
                .within(Ramps.GENTLEST, limits.accelerationMmPerSec2());
        Parameter turning = Parameter.number("turnAcceleration", Unit.DEG_PER_S2, "how sharply its turns speed up")
                .within(Ramps.GENTLEST, limits.turnAccelerationDegPerSec2());
        Parameter braking = Parameter.number("deceleration", Unit.MM_PER_S2, "how sharply it brakes")
                .within(Ramps.GENTLEST, limits.accelerationMmPerSec2());
        Parameter ending = Parameter.number("turnDeceleration", Unit.DEG_PER_S2, "how sharply its turns end")
                .within(Ramps.GENTLEST, limits.turnAccelerationDegPerSec2());
        add(table, straight, Ramps::acceleration, Ramps::withAcceleration);
        add(table, braking, Ramps::deceleration, Ramps::withDeceleration);
        add(table, turning, Ramps::turnAcceleration, Ramps::withTurnAcceleration);
        add(table, ending, Ramps::turnDeceleration, Ramps::withTurnDeceleration);
    }

    private void add(ParameterTable table, Parameter parameter, Part part, Changed changed) {
        table.add(parameter, access.session(open -> Value.of(part.of(open.ramps()), parameter.unit())))
                .kept()
                .writes(values -> change.accept(ramps ->
                        changed.by(ramps, (int) Math.round(values.get(0).number()))));
    }
}
