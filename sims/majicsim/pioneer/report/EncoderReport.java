package majicsim.pioneer.report;

import majicsim.pioneer.board.Board;
import majicsim.pioneer.packet.PacketWriter;

/**
 * The encoder packet (ARCOS sheet 11.1): counters of 32 bits that roll over.
 *
 * @param leftMm the distance of the left wheel since the start
 * @param rightMm the distance of the right wheel since the start
 */
public record EncoderReport(double leftMm, double rightMm) {
    /** About the resolution of a P3-DX. */
    public static final int TICKS_PER_MM = 128;

    static EncoderReport of(Board board) {
        double middle = board.drive().countedMm();
        double aside = board.model().scaling().wheelMmPerSec(board.drive().countedDeg());
        return new EncoderReport(middle - aside, middle + aside);
    }

    public byte[] toBytes() {
        return new PacketWriter(0x90).int32(ticks(leftMm)).int32(ticks(rightMm)).toBytes();
    }

    private static int ticks(double mm) {
        return (int) Math.round(mm * TICKS_PER_MM);
    }
}
