package majic.pioneer;

import java.util.List;
import java.util.OptionalInt;
import majic.pioneer.arcos.Batteries;
import majic.pioneer.arcos.SipTail;

/**
 * How the robot is supplied (ARCOS sheet 8, 8.1, 11.3). Immutable.
 *
 * @param volts of the battery
 * @param percent charge; empty on robots that cannot tell, and most cannot
 * @param charging what the charger does
 * @param chargerConnected whether the charger's supply is good
 * @param cells what batteries with electronics say of themselves; empty until heard
 */
record Power(
        double volts, OptionalInt percent, Charging charging, boolean chargerConnected, List<Batteries.Cell> cells) {
    private static final int CHARGER_GOOD = 1 << 10;

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

    /** Robots that do not know send zero. */
    private static OptionalInt percent(int told, List<Batteries.Cell> cells) {
        if (told != SipTail.ABSENT && told > 0) {
            return OptionalInt.of(told);
        }
        return cells.isEmpty()
                ? OptionalInt.empty()
                : OptionalInt.of((int) Math.round(cells.stream()
                        .mapToInt(Batteries.Cell::relativePercent)
                        .average()
                        .orElse(0)));
    }
}
