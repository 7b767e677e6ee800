package majic.pioneer.parameters;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.ReportKind;
import majic.pioneer.state.Equipment;

/**
 * The controller's digital and analog ports, for equipment of a lab. Setting them moves no part of the robot itself.
 */
final class InputOutputParameters implements ParameterTheme<Equipment> {
    private static final int LINES = 8;
    private static final int BYTE = 0xFF;

    /** Analog inputs that the SIP can show. */
    private static final int LAST_PORT = 7;

    private final PioneerAccess access;

    InputOutputParameters(PioneerAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        describeInputs(table);
        describeOutputs(table);
        table.add(
                        Parameter.number("analogPort", Unit.NONE, "which analog input \"analog\" shows")
                                .within(0, LAST_PORT)
                                .inWholes(),
                        access.state(state -> number(state.ports().analogPort())))
                .writes(values -> select((int) values.get(0).number()));
        table.add(
                Parameter.number("analog", Unit.V, "the chosen analog input, 0 to 5 V"),
                access.state(state -> volts(state.ports().analogVolts())));
        table.add(
                Parameter.list("analogs", Unit.V, "all analog inputs, 0 to 5 V, the battery last; requested when read"),
                access.report(
                        ReportKind.PORTS,
                        state -> all(state.ports().allAnalogVolts().stream()
                                .map(volts -> Value.of(volts, Unit.V))
                                .toList())));
        table.add(
                Parameter.list(
                        "digitalIns", Unit.NONE, "all bytes of digital inputs, the user's first; requested when read"),
                access.report(
                        ReportKind.PORTS,
                        state -> all(state.ports().allDigitalIn().stream()
                                .map(bits -> Value.of(bits, Unit.NONE))
                                .toList())));
    }

    private static Optional<Value> all(List<Value> values) {
        return values.isEmpty() ? Optional.empty() : Optional.of(Value.many(values));
    }

    private void describeInputs(ParameterTable table) {
        table.add(
                Parameter.number("digitalIn", Unit.NONE, "all digital inputs as one number, input 0 lowest")
                        .within(0, BYTE),
                access.state(state -> number(state.ports().digitalIn())));
        for (int line = 0; line < LINES; line++) {
            int bit = 1 << line;
            table.add(
                    Parameter.onOff("digitalIn" + line, "this digital input; an open one is on"),
                    access.state(state -> flag(state.ports().digitalIn(), bit)));
        }
    }

    private void describeOutputs(ParameterTable table) {
        table.add(
                        Parameter.number("digitalOut", Unit.NONE, "all digital outputs as one number, output 0 lowest")
                                .within(0, BYTE)
                                .inWholes(),
                        access.state(state -> number(state.ports().digitalOut())))
                .writes(values -> put((int) values.get(0).number(), BYTE));
        for (int line = 0; line < LINES; line++) {
            int bit = 1 << line;
            table.add(
                            Parameter.onOff("digitalOut" + line, "this digital output"),
                            access.state(state -> flag(state.ports().digitalOut(), bit)))
                    .writes(values -> put(values.get(0).isYes() ? bit : 0, bit));
        }
    }

    private void put(int states, int mask) {
        Packet packet = ArcosCommand.DIGOUT.packet(states, mask);
        if (access.open().state().ports().digitalOut().isEmpty()) {
            access.send(packet);
            return;
        }
        access.sendAndConfirm(
                packet,
                state -> (state.ports().digitalOut().orElse(~states) & mask) == states,
                "the digital outputs did not change");
    }

    private void select(int port) {
        access.sendAndConfirm(
                ArcosCommand.ADSEL.packet(port),
                state -> state.ports().analogPort().orElse(port) == port,
                "the robot did not change to analog input " + port);
    }

    private static Value number(OptionalInt reported) {
        return reported.isEmpty() ? PioneerAccess.NOT_REPORTED : Value.of(reported.getAsInt(), Unit.NONE);
    }

    private static Value flag(OptionalInt bits, int bit) {
        return bits.isEmpty() ? PioneerAccess.NOT_REPORTED : Value.onOff((bits.getAsInt() & bit) != 0);
    }

    private static Value volts(OptionalDouble reported) {
        return reported.isEmpty() ? PioneerAccess.NOT_REPORTED : Value.of(reported.getAsDouble(), Unit.V);
    }
}
