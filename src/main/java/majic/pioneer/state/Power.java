package majic.pioneer.state;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import majic.pioneer.arcos.Batteries;

/**
 * How the robot is supplied (ARCOS sheet 8, 8.1, 11.3). Immutable.
 *
 * @param volts of the battery
 * @param percent charge; empty on robots that cannot tell, and most cannot
 * @param charging what the charger does
 * @param chargerConnected whether the charger's supply is good
 * @param cells what batteries with electronics say of themselves; empty until heard
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
                percent(state.sip().tail().chargePercent(), cells),
                Charging.of(state.sip().tail()),
                (state.sip().flags() & CHARGER_GOOD) != 0,
                cells);
    }

    /** Robots that do not know send zero; more than all there is means as little. */
    private static OptionalInt percent(int told, List<Batteries.Cell> cells) {
        OptionalInt charge = told > 0 ? OptionalInt.of(told) : mean(cells);
        return charge.orElse(0) <= FULL_PERCENT ? charge : OptionalInt.empty();
    }

    private static OptionalInt mean(List<Batteries.Cell> cells) {
        OptionalDouble mean =
                cells.stream().mapToInt(Batteries.Cell::relativePercent).average();
        return mean.isPresent() ? OptionalInt.of((int) Math.round(mean.getAsDouble())) : OptionalInt.empty();
    }
}
