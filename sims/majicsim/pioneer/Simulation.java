package majicsim.pioneer;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** What one client has of the simulator beside the robot (ARCOS sheet 6.2): its laser, and orders to the simulator itself. */
final class Simulation {
    private final Board board;
    private final SimLaser laser;
    private final OldLaserCommands oldLaserCommands;

    Simulation(Board board) {
        this.board = board;
        this.laser = new SimLaser(board);
        this.oldLaserCommands = new OldLaserCommands(laser);
    }

    SimLaser laser() {
        return laser;
    }

    /** Whether this command was the laser's by its old number; if not, it is the robot's. */
    boolean take(int id, Argument argument) {
        return oldLaserCommands.take(id, argument.integer());
    }

    /** SIM_CTRL: obeys; returns the packet that answers it, or null. */
    byte @Nullable [] control(Argument order) {
        return SimControl.answer(order, board, laser);
    }

    /** What follows the SIP of this cycle. */
    List<byte[]> packets() {
        return laser.packets();
    }
}
