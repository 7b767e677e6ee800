package majicsim.pioneer.session;

import java.util.List;
import java.util.function.Consumer;
import majicsim.pioneer.board.Board;
import majicsim.pioneer.packet.Argument;
import majicsim.pioneer.report.Report;
import majicsim.pioneer.report.Reports;
import majicsim.pioneer.report.SimStat;

/**
 * One client's access to the simulator besides the robot (ARCOS sheet 6.2): its laser, and commands for the simulator
 * itself.
 */
final class Simulation {
    private final Board board;
    private final Reports reports;
    private final Consumer<byte[]> client;
    private final SimLaser laser;

    /** Adds packets to {@code reports}, and answers to {@code client} at once. */
    Simulation(Board board, Reports reports, Consumer<byte[]> client) {
        this.board = board;
        this.reports = reports;
        this.client = client;
        this.laser = new SimLaser(board);
    }

    SimLaser laser() {
        return laser;
    }

    /** Executes a command with an old number of the laser; returns false if it is for the robot. */
    boolean take(int id, Argument argument) {
        return laser.takeOld(id, argument.integer());
    }

    /** SIM_STAT: once and now, with every SIP, or no more. */
    void stat(int mode) {
        if (mode == 1) {
            client.accept(SimStat.of(board).toBytes());
        } else {
            reports.ask(Report.SIM_STAT, mode);
        }
    }

    /** SIM_CTRL. */
    void control(Argument order) {
        byte[] answer = SimControl.answer(order, board, laser);
        if (answer != null) {
            client.accept(answer);
        }
    }

    /** The packets after the SIP of this cycle. */
    List<byte[]> packets() {
        return laser.packets();
    }
}
