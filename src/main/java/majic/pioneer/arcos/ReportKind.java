package majic.pioneer.arcos;

import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * The reports that a robot sends beside its SIPs, only on request: the type of their packet, their request, and how
 * they are read (ARCOS sheet 6.1, 11).
 */
public enum ReportKind {
    /** Batteries with electronics of their own. */
    BATTERIES(0xFA, ArcosCommand.BATTERYINFO, 0, Batteries.class, Batteries::read),
    /** All inputs and outputs. */
    PORTS(0xF0, ArcosCommand.IOREQUEST, 0, InputsOutputs.class, InputsOutputs::read),
    /** The kind of gripper. */
    GRIPPER(0xE0, ArcosCommand.GRIPREQUEST, 3, GripperReport.class, GripperReport::read),
    /** The gyro, if it is one that the client reads. */
    GYRO(0x98, ArcosCommand.GYRO, 0, Gyro.class, Gyro::read),
    /** The wheels' encoders. */
    ENCODERS(0x90, ArcosCommand.ENCODER, 8, Encoders.class, Encoders::read),
    /** The joystick plugged into the robot. */
    JOYSTICK(0xF8, ArcosCommand.JOYINFO, 8, Joystick.class, Joystick::read);

    private static final ReportKind[] KINDS = values();

    private final int type;
    private final ArcosCommand request;
    private final int leastBytes;
    private final Class<? extends Report> report;
    private final Function<FieldReader, Report> reader;

    ReportKind(
            int type,
            ArcosCommand request,
            int leastBytes,
            Class<? extends Report> report,
            Function<FieldReader, Report> reader) {
        this.type = type;
        this.request = request;
        this.leastBytes = leastBytes;
        this.report = report;
        this.reader = reader;
    }

    /**
     * Decodes a packet.
     *
     * @return null if it is of no such kind, or too short to mean anything
     */
    public static @Nullable Report decode(Packet packet) {
        for (ReportKind kind : KINDS) {
            if (kind.type == packet.type) {
                return packet.data.length < kind.leastBytes ? null : kind.reader.apply(packet.fields());
            }
        }
        return null;
    }

    /** The kind of a report. */
    public static ReportKind of(Report some) {
        for (ReportKind kind : KINDS) {
            if (kind.report == some.getClass()) {
                return kind;
            }
        }
        throw new IllegalArgumentException("no robot sends " + some);
    }

    /** The request for a report with every SIP. */
    public Packet stream() {
        return request.packet(request.argument().most());
    }

    /** The request for a single report; the gyro has no single reports and streams. */
    public Packet once() {
        return request.packet(1);
    }

    /**
     * Whether it is requested at connecting already. Encoders and joystick are rarely used, and requests for missing
     * equipment have other meanings to some robots, so those are requested only while something reads them.
     */
    public boolean isRequestedAtStart(@Nullable Config config) {
        return switch (this) {
            case BATTERIES, PORTS -> true;
            case GRIPPER -> config != null && config.number(ConfigField.GRIPPER) != 0;
            case GYRO -> config != null && config.number(ConfigField.HASGYRO) == 1;
            case ENCODERS, JOYSTICK -> false;
        };
    }
}
