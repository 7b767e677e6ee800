package majic.pioneer.state;

import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Batteries;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.ConfigField;
import majic.pioneer.arcos.Encoders;
import majic.pioneer.arcos.GripperReport;
import majic.pioneer.arcos.Gyro;
import majic.pioneer.arcos.InputsOutputs;
import majic.pioneer.arcos.Joystick;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.Report;
import org.jspecify.annotations.Nullable;

/** The reports that a robot sends only on request, and their requests (ARCOS sheet 6.1, 11). */
public enum RequestedReport {
    /** Batteries with electronics of their own. */
    BATTERIES(ArcosCommand.BATTERYINFO, Batteries.class),
    /** All inputs and outputs. */
    PORTS(ArcosCommand.IOREQUEST, InputsOutputs.class),
    /** The kind of gripper. */
    GRIPPER(ArcosCommand.GRIPREQUEST, GripperReport.class),
    /** The gyro, if it is one that the client reads. */
    GYRO(ArcosCommand.GYRO, Gyro.class),
    /** The wheels' encoders. */
    ENCODERS(ArcosCommand.ENCODER, Encoders.class),
    /** The joystick plugged into the robot. */
    JOYSTICK(ArcosCommand.JOYINFO, Joystick.class);

    private final ArcosCommand request;
    private final Class<? extends Report> report;

    RequestedReport(ArcosCommand request, Class<? extends Report> report) {
        this.request = request;
        this.report = report;
    }

    public boolean brings(Report some) {
        return report == some.getClass();
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
