package majic.time;

import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import majic.drivertest.TestClock;
import majic.link.Links;
import majic.simulation.TransitCheck;
import majicsim.net.LineCount;

/** Makes stepped clocks for peers that have threads and several connections of their own. */
public final class PeerClock {
    private PeerClock() {}

    /**
     * Creates a clock for the peer at an address and its clients. Time does not advance while data is in transit
     * between them, so the speed of the computer does not matter.
     */
    public static TestClock between(String address, Supplier<List<LineCount>> lines) {
        return new TestClock(nanos -> {}, new TransitCheck(Links::traffic, lines, Set.of(address)));
    }
}
