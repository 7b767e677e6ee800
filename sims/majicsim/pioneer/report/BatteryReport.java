package majicsim.pioneer.report;

import majicsim.pioneer.board.Board;
import majicsim.pioneer.packet.PacketWriter;

/** The battery packet (ARCOS sheet 11.3): one entry for each battery that reports itself; lead-acid ones do not. */
final class BatteryReport {
    private static final int BYTES_PER_BATTERY = 5;
    private static final int NO_FLAGS = 0;

    private BatteryReport() {}

    static byte[] of(Board board) {
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
