package majic.pioneer.parameters;

import java.util.List;
import java.util.Optional;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.AssumedSetting;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.ConfigField;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Side;
import majic.pioneer.state.SonarScan;

/** Sonar ranges, the distances made of them, and the power of the sonars. */
final class SonarParameters implements ParameterTheme<Equipment> {
    /** An echo from 5 m comes after 30 ms; a tenth of a second is a whole SIP. */
    private static final int FASTEST_MS = 10;

    private static final int SLOWEST_MS = 1000;

    private final PioneerAccess access;
    private final AssumedSetting cycle = new AssumedSetting();

    SonarParameters(PioneerAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        for (Side side : Side.values()) {
            if (equipment.model().discs().stream().anyMatch(side::isCoveredBy)) {
                table.add(
                        Parameter.number(side.parameter(), Unit.MM, side.help()),
                        access.sonar(state -> state.gaps().containsKey(side), state -> gap(side, state)));
            }
        }
        List<Integer> discs = equipment.discs();
        if (!discs.isEmpty()) {
            describeDiscs(table, discs);
            describePower(table, equipment.sonarArrays());
        }
    }

    private void describeDiscs(ParameterTable table, List<Integer> discs) {
        table.add(
                Parameter.list("sonar", Unit.MM, "all sonar ranges in the order of the discs"),
                access.sonar(
                        state -> discs.stream().allMatch(state.sonar()::hasReading),
                        state -> Value.many(
                                discs.stream().map(disc -> range(disc, state)).toList())));
        for (int disc : discs) {
            table.add(
                    Parameter.number("sonar" + disc, Unit.MM, "range from the surface of this sonar disc"),
                    access.sonar(state -> state.sonar().hasReading(disc), state -> range(disc, state)));
        }
    }

    private void describePower(ParameterTable table, List<Integer> arrays) {
        table.add(
                        Parameter.onOff("sonarPower", "whether the sonars fire"),
                        access.state(state -> Value.onOff(state.sonarOn())))
                .writes(values -> power(values.get(0).isYes()));
        if (arrays.size() > 1) {
            arrays.forEach(array -> table.add(
                            Parameter.onOff("sonarPower" + array, "whether this array of eight discs fires"),
                            access.state(state -> Value.onOff(state.sonarOn(array))))
                    .writes(values -> power(array, values.get(0).isYes())));
        }
        table.add(
                        Parameter.number("sonarCycle", Unit.MS, "from one disc of an array to the next")
                                .within(FASTEST_MS, SLOWEST_MS)
                                .inWholes(),
                        access.assumed(
                                cycle,
                                access.config(
                                        ConfigField.SONARCYCLE,
                                        config ->
                                                Optional.of(Value.of(config.number(ConfigField.SONARCYCLE), Unit.MS)))))
                .writes(values -> access.send(
                        cycle,
                        ArcosCommand.SONARCYCLE.packet((int) values.get(0).number()),
                        values.get(0)));
    }

    private void power(boolean on) {
        access.sendAndConfirm(
                ArcosCommand.SONAR.packet(on ? 1 : 0),
                state -> state.sonarOn() == on,
                "the sonars " + PioneerAccess.didNotSwitch(on));
    }

    /** One array, 1 to 4: bit 0 switches, a bit above chooses the array, none all of them (ARCOS sheet 6.1). */
    private void power(int array, boolean on) {
        access.sendAndConfirm(
                ArcosCommand.SONAR.packet(1 << array | (on ? 1 : 0)),
                state -> state.sonarOn(array) == on,
                "sonar array " + array + " " + PioneerAccess.didNotSwitch(on));
    }

    private static Value range(int disc, PioneerState state) {
        if (!state.sonar().hasReading(disc)) {
            return state.sonarOn() ? PioneerAccess.NOTHING_YET : Value.unknown("the sonars are off");
        }
        int range = state.sonar().rangeMm(disc);
        return range >= SonarScan.NOTHING_MM ? Value.CLEAR : Value.of(range, Unit.MM);
    }

    private static Value gap(Side side, PioneerState state) {
        Double gap = state.gaps().get(side);
        if (gap == null) {
            return state.sonarOn() ? PioneerAccess.NOTHING_YET : Value.unknown("the sonars are off");
        }
        return gap.isInfinite() ? Value.CLEAR : Value.of(Math.round(gap), Unit.MM);
    }
}
