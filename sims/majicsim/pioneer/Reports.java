package majicsim.pioneer;

import java.util.ArrayList;
import java.util.List;

/** The packets of one SIP cycle: the SIP, and what the client asked for beside it, in the sheet's order (5.4, 11). */
final class Reports {
    private final Board board;
    private final Subscription simStat = new Subscription();
    private final Subscription inputsAndOutputs = new Subscription();
    private final Subscription encoders = new Subscription();
    private final Subscription batteries = new Subscription();

    Reports(Board board) {
        this.board = board;
    }

    Subscription simStat() {
        return simStat;
    }

    Subscription inputsAndOutputs() {
        return inputsAndOutputs;
    }

    Subscription encoders() {
        return encoders;
    }

    Subscription batteries() {
        return batteries;
    }

    /** The packets of this cycle, each for a write of its own. */
    List<byte[]> next() {
        List<byte[]> packets = new ArrayList<>();
        if (simStat.isDue()) {
            packets.add(board.simStat());
        }
        packets.add(board.sip().toBytes());
        if (inputsAndOutputs.isDue()) {
            packets.add(board.inputsAndOutputs());
        }
        if (encoders.isDue()) {
            packets.add(board.encoders());
        }
        if (batteries.isDue()) {
            packets.add(board.batteries());
        }
        return packets;
    }
}
