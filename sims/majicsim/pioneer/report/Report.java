package majicsim.pioneer.report;

import java.util.function.Function;
import majicsim.pioneer.board.Board;

/**
 * The packets of a cycle in the order in which they are sent: some before the SIP, some after it (ARCOS sheet 5.4, 11).
 */
public enum Report {
    SIM_STAT(board -> SimStat.of(board).toBytes()),
    JOYSTICK(board -> board.devices().joystick().toBytes()),
    GYRO(board -> board.devices().gyro().toBytes(board.devices().thermometer().celsius())),
    SIP(board -> Sip.of(board).toBytes()),
    IO(InputOutputReport::of),
    ENCODER(board -> EncoderReport.of(board).toBytes()),
    GRIPPER(board -> board.devices().gripper().toBytes()),
    BATTERY(BatteryReport::of);

    private final Function<Board, byte[]> writer;

    Report(Function<Board, byte[]> writer) {
        this.writer = writer;
    }

    byte[] of(Board board) {
        return writer.apply(board);
    }
}
