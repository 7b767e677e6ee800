package majic.pioneer.arcos;

import org.jspecify.annotations.Nullable;

/** What a robot tells only when it is asked to, beside its SIPs: one packet's fields as sent (ARCOS sheet 11). Immutable. */
public sealed interface Report
        permits Encoders, InputsOutputs, Batteries, Joystick, GripperReport, Gyro, AuxBytes, CompassBytes {
    /** The controller was reset in the middle of a session; it has forgotten all it was told (ARCOS sheet 11.6). */
    int RESET_FROM = 0xFE;

    /**
     * Decodes a packet.
     *
     * @return null if it is of another kind, or too short to mean anything
     */
    static @Nullable Report decode(Packet packet) {
        return switch (packet.type()) {
            case Encoders.TYPE -> Encoders.read(packet.fields());
            case InputsOutputs.TYPE -> InputsOutputs.read(packet.fields());
            case Batteries.TYPE -> Batteries.read(packet.fields());
            case Joystick.TYPE -> Joystick.read(packet.fields());
            case GripperReport.TYPE -> GripperReport.read(packet.fields());
            case Gyro.TYPE -> Gyro.read(packet.fields());
            case CompassBytes.TYPE -> new CompassBytes(packet.data());
            default -> AuxBytes.read(packet);
        };
    }
}
