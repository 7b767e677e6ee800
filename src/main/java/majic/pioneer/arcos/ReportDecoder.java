package majic.pioneer.arcos;

import org.jspecify.annotations.Nullable;

/** Decodes the packets that come beside the SIPs (ARCOS sheet 11). */
public final class ReportDecoder {
    private ReportDecoder() {}

    /**
     * Decodes a packet.
     *
     * @return null if it is of another kind, or too short to mean anything
     */
    public static @Nullable Report decode(Packet packet) {
        return switch (packet.type()) {
            case Encoders.TYPE -> Encoders.read(packet.fields());
            case InputsOutputs.TYPE -> InputsOutputs.read(packet.fields());
            case Batteries.TYPE -> Batteries.read(packet.fields());
            case Joystick.TYPE -> Joystick.read(packet.fields());
            case GripperReport.TYPE -> GripperReport.read(packet.fields());
            case Gyro.TYPE -> Gyro.read(packet.fields());
            default -> null;
        };
    }
}
