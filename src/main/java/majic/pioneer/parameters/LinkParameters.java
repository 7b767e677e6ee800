package majic.pioneer.parameters;

import java.util.function.Supplier;
import java.util.function.ToLongFunction;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.state.Equipment;

/** The quality of the link. */
final class LinkParameters implements ParameterTheme<Equipment> {
    private final PioneerAccess access;

    LinkParameters(PioneerAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        table.add(
                Parameter.number("packetRate", Unit.NONE, "state packets from the robot a second; about 10"),
                access.state(state -> Value.of(Math.round(10 * state.sipsPerSec()) / 10.0, Unit.NONE)));
        table.add(
                Parameter.number(
                        "longestSilence", Unit.MS, "the longest time between two of them since it was connected"),
                access.state(state -> Value.of(state.longestSilenceS() * 1000, Unit.MS)));
        table.add(
                Parameter.number("damagedPackets", Unit.NONE, "with a wrong checksum, since it was connected"),
                count(PacketCounts::damagedPackets));
        table.add(
                Parameter.number("skippedBytes", Unit.NONE, "that belonged to no whole packet, since it was connected"),
                count(PacketCounts::skippedBytes));
    }

    private Supplier<Value> count(ToLongFunction<PacketCounts> part) {
        return access.session(open -> {
            PacketCounts counts = open.packetCounts();
            return counts == null ? PioneerAccess.missing(open) : Value.of(part.applyAsLong(counts), Unit.NONE);
        });
    }
}
