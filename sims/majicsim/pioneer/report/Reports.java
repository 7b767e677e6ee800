package majicsim.pioneer.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import majicsim.pioneer.board.Board;
import majicsim.pioneer.devices.AuxPort;

/** The packets for one client in each cycle: the SIP, other requested packets, and bytes from the AUX ports. */
public final class Reports {
    private static final Report[] ALL = Report.values();

    private final Board board;
    private final Subscription[] subscriptions = new Subscription[ALL.length];

    public Reports(Board board) {
        this.board = board;
        Arrays.setAll(subscriptions, report -> new Subscription());
        ask(Report.SIP, Subscription.EVERY_CYCLE);
    }

    /** Requests a packet: 0 none, 1 once, 2 or more every cycle. */
    public void ask(Report report, int argument) {
        subscriptions[report.ordinal()].ask(argument);
    }

    /** GYRO: its packets with every SIP or none, where there is a gyro. */
    public void requestGyro(boolean on) {
        boolean wanted = on && board.model().equipment().hasGyro();
        ask(Report.GYRO, wanted ? Subscription.EVERY_CYCLE : Subscription.NEVER);
    }

    /** The packets of this cycle, each for a write of its own. */
    public List<byte[]> next() {
        List<byte[]> packets = new ArrayList<>();
        for (Report report : ALL) {
            if (subscriptions[report.ordinal()].isDue()) {
                packets.add(report.of(board));
            }
        }
        for (AuxPort port : board.devices().auxPorts()) {
            byte[] packet = port.nextPacket();
            if (packet != null) {
                packets.add(packet);
            }
        }
        return packets;
    }

    /**
     * A client's request for an extra packet: argument 0 none, 1 one, 2 or more one with every SIP (ARCOS sheet 6.1,
     * 11).
     */
    private static final class Subscription {
        static final int NEVER = 0;
        static final int EVERY_CYCLE = 2;

        private int requested;

        void ask(int argument) {
            requested = argument;
        }

        /** Whether a packet is due with this SIP. */
        boolean isDue() {
            boolean due = requested > 0;
            if (requested == 1) {
                requested = 0;
            }
            return due;
        }
    }
}
