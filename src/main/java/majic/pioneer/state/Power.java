package majic.pioneer.state;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import majic.pioneer.arcos.Batteries;
import majic.pioneer.arcos.SipField;

/**
 * Battery and charger (ARCOS sheet 8, 8.1, 11.3). Immutable.
 *
 * @param volts of the battery
 * @param percent charge; empty on robots that do not report it, which are most
 * @param charging state of charging
 * @param chargerConnected whether a charger supplies power
 * @param cells reports of batteries with electronics; empty before the first
 */
public record Power(
        double volts, OptionalInt percent, Charging charging, boolean chargerConnected, List<Batteries.Cell> cells) {
    private static final int CHARGER_GOOD = 1 << 10;
    private static final int FULL_PERCENT = 100;

    /** From a SIP and from what came with it. */
    static Power of(PioneerState state) {
        List<Batteries.Cell> cells =
                state.reports().latest(Batteries.class).map(Batteries::cells).orElse(List.of());
        return new Power(
                state.volts(),
                percent(state.sip().get(SipField.CHARGE_PERCENT), cells),
                Charging.of(state.sip().get(SipField.CHARGE_STATE)),
                (state.sip().get(SipField.FLAGS) & CHARGER_GOOD) != 0,
                cells);
    }

    /** Zero and values above 100 mean that the charge is not known. */
    private static OptionalInt percent(int reported, List<Batteries.Cell> cells) {
        OptionalInt charge = reported > 0 ? OptionalInt.of(reported) : mean(cells);
        return charge.orElse(0) <= FULL_PERCENT ? charge : OptionalInt.empty();
    }

    private static OptionalInt mean(List<Batteries.Cell> cells) {
        OptionalDouble mean =
                cells.stream().mapToInt(Batteries.Cell::relativePercent).average();
        return mean.isPresent() ? OptionalInt.of((int) Math.round(mean.getAsDouble())) : OptionalInt.empty();
    }
}
