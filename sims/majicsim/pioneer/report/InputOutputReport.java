package majicsim.pioneer.report;

import majicsim.pioneer.board.Board;
import majicsim.pioneer.devices.Devices;
import majicsim.pioneer.devices.UserPort;
import majicsim.pioneer.packet.PacketWriter;

/**
 * The IO packet (ARCOS sheet 11.2): digital inputs, bumpers front and rear, infra-red, all active low; outputs; the
 * analog ports, and the battery last.
 */
final class InputOutputReport {
    private static final int INPUT_BYTES = 4;
    private static final int OUTPUT_BYTES = 1;
    /** How the battery's voltage shows among the analog values: our own scale, 25.6 V full. */
    private static final int ANALOG_PER_TENTH_VOLT = 4;

    private static final int ANALOG_FULL = 1023;

    private InputOutputReport() {}

    static byte[] of(Board board) {
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
}
