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
import majic.pioneer.arcos.Report;
import org.jspecify.annotations.Nullable;

/** What a robot can be asked to send beside its SIPs, and how (ARCOS sheet 6.1, 11). */
public enum Feed {
    /** Batteries with electronics of their own. */
    BATTERIES(ArcosCommand.BATTERYINFO, Batteries.class),
    /** All inputs and outputs. */
    PORTS(ArcosCommand.IOREQUEST, InputsOutputs.class),
    /** Which gripper there is. */
    GRIPPER(ArcosCommand.GRIPREQUEST, GripperReport.class),
    /** The gyro, where the client has to read it. */
    GYRO(ArcosCommand.GYRO, Gyro.class),
    /** The wheels' encoders. */
    ENCODERS(ArcosCommand.ENCODER, Encoders.class),
    /** The joystick plugged into the robot. */
    JOYSTICK(ArcosCommand.JOYINFO, Joystick.class);

    private final ArcosCommand request;
    private final Class<? extends Report> report;

    Feed(ArcosCommand request, Class<? extends Report> report) {
        this.request = request;
        this.report = report;
    }

    public boolean brings(Report some) {
        return report.isInstance(some);
    }

    /** Asks for one with every SIP. */
    public byte[] stream() {
        return request.packet(request.argument().most());
    }

    /** Asks for a single one; the gyro knows no such thing. */
    public byte[] once() {
        return request.packet(1);
    }

    /**
     * Whether it is asked for at connecting already. Encoders and joystick are for few, and numbers of equipment that is not
     * there mean other things to some robots, so those wait for somebody who reads them.
     */
    public boolean isAskedFromTheStart(@Nullable Config config) {
        return switch (this) {
            case BATTERIES, PORTS -> true;
            case GRIPPER -> config != null && config.has(ConfigField.GRIPPER);
            case GYRO -> config != null && config.number(ConfigField.HASGYRO) == 1;
            case ENCODERS, JOYSTICK -> false;
        };
    }
}
