package majicsim.pioneer.report;

import java.util.function.Function;
import majicsim.pioneer.board.Board;
import majicsim.pioneer.devices.Devices;
import majicsim.pioneer.devices.UserPort;
import majicsim.pioneer.packet.PacketWriter;

/**
 * The packets of a cycle in the order in which they are sent: some before the SIP, some after it (ARCOS sheet 5.4, 11).
 */
public enum Report {
    SIM_STAT(board -> SimStat.of(board).toBytes()),
    JOYSTICK(board -> board.devices().joystick().toBytes()),
    GYRO(board -> board.devices().gyro().toBytes(board.devices().thermometer().celsius())),
    SIP(board -> Sip.of(board).toBytes()),
    IO(Report::inputOutput),
    ENCODER(board -> EncoderReport.of(board).toBytes()),
    GRIPPER(board -> board.devices().gripper().toBytes()),
    BATTERY(Report::battery);

    private static final int INPUT_BYTES = 4;
    private static final int OUTPUT_BYTES = 1;
    /** How the battery's voltage shows among the analog values: our own scale, 25.6 V full. */
    private static final int ANALOG_PER_TENTH_VOLT = 4;

    private static final int ANALOG_FULL = 1023;
    private static final int BYTES_PER_BATTERY = 5;
    private static final int NO_FLAGS = 0;

    private final Function<Board, byte[]> writer;

    Report(Function<Board, byte[]> writer) {
        this.writer = writer;
    }

    byte[] of(Board board) {
        return writer.apply(board);
    }

    /**
     * The IO packet (ARCOS sheet 11.2): digital inputs, bumpers front and rear, infra-red, all active low; outputs; the
     * analog ports, and the battery last.
     */
    private static byte[] inputOutput(Board board) {
        Devices devices = board.devices();
        UserPort port = devices.userPort();
        PacketWriter packet = new PacketWriter(0xF0)
                .uint8(INPUT_BYTES)
                .uint8(port.digitalIn())
                .uint8(~board.bumpers().front())
                .uint8(~board.bumpers().rear())
                .uint8(devices.infrared().activeLow())
                .uint8(OUTPUT_BYTES)
                .uint8(port.digitalOut())
                .uint8(UserPort.ANALOG_PORTS + 1);
        for (int i = 0; i < UserPort.ANALOG_PORTS; i++) {
            packet.uint16(port.analog(i));
        }
        int battery = devices.battery().tenthVolts() * ANALOG_PER_TENTH_VOLT;
        return packet.uint16(Math.min(ANALOG_FULL, battery)).toBytes();
    }

    /** The battery packet (ARCOS sheet 11.3): one entry for each battery that reports itself; lead-acid ones do not. */
    private static byte[] battery(Board board) {
        int batteries = board.model().equipment().smartBatteries();
        int percent = board.devices().battery().percent();
        PacketWriter packet = new PacketWriter(0xFA).uint8(batteries).uint8(BYTES_PER_BATTERY);
        for (int i = 0; i < batteries; i++) {
            packet.uint8(NO_FLAGS)
                    .uint8(NO_FLAGS)
                    .uint8(NO_FLAGS)
                    .uint8(percent)
                    .uint8(percent);
        }
        return packet.toBytes();
    }
}
