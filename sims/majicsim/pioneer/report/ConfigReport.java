package majicsim.pioneer.report;

import java.util.function.ToIntFunction;
import majicsim.pioneer.board.Board;
import majicsim.pioneer.devices.Thermometer;
import majicsim.pioneer.model.Equipment;
import majicsim.pioneer.model.Generation;
import majicsim.pioneer.model.PioneerModel;
import majicsim.pioneer.model.Setting;
import majicsim.pioneer.model.Settings;
import majicsim.pioneer.motion.Limits;
import majicsim.pioneer.motion.MotionLimits;
import majicsim.pioneer.packet.PacketWriter;

/**
 * The CONFIG packet (ARCOS sheet 10), as far as the model's generation of firmware has it. Serial number and version
 * tell clients that this is a simulator.
 *
 * @param robotName the owner's name for the robot
 * @param model class, subclass, sonar, bumpers and equipment
 * @param tops the highest values of the limits
 * @param limits the present limits
 * @param settings the working values of what is stored
 * @param sonarCycleMs the sonar's firing period, 0 to 255
 * @param hostBaud the code of this port's speed, 0 to 4
 */
public record ConfigReport(
        String robotName,
        PioneerModel model,
        MotionLimits tops,
        MotionLimits limits,
        ToIntFunction<Setting> settings,
        int sonarCycleMs,
        int hostBaud) {
    public static final int SIP_CYCLE_MS = 100;

    private static final int TYPE = 0x20;
    private static final String SERIAL_NUMBER = "SIM";
    public static final String VERSION = "S.0";
    private static final String BOOT_LOADER = "S.0";
    private static final int PWM_MAX = 400;
    private static final int AUTOBAUD_AUTOMATIC = 2;
    private static final int NO_SIDEWAYS_TOP = 9999;
    private static final int GYRO_LIMIT_DEG_PER_SEC = 300;
    private static final int LOW_CHARGE_PERCENT = 20;
    private static final int SHUTDOWN_CHARGE_PERCENT = 5;

    public static byte[] of(Board board) {
        Settings settings = board.devices().settings();
        return new ConfigReport(
                        board.name(),
                        board.model(),
                        MotionLimits.tops(board.model()),
                        board.drive().limits(),
                        settings::get,
                        Math.min(255, board.sonar().cycleMs()),
                        board.devices().hostBaud().code())
                .toBytes();
    }

    byte[] toBytes() {
        PacketWriter packet = new PacketWriter(TYPE);
        packet.text(model.className()).text(model.subclass()).text(SERIAL_NUMBER);
        packet.uint8(0).uint16s(speed(tops.rotation()), speed(tops.translation()));
        packet.uint16s(acceleration(tops.rotation()), acceleration(tops.translation()), PWM_MAX);
        packet.text(robotName);
        writeEquipment(packet);
        writeMotion(packet);
        Generation generation = model.equipment().generation();
        if (generation.isAtLeast(Generation.AROS)) {
            writeAros(packet);
        }
        if (generation.isAtLeast(Generation.ARCOS)) {
            writeArcos(packet);
        }
        return packet.toBytes();
    }

    /** SIPCYCLE to JOYRVEL, fields 11 to 24. */
    private void writeEquipment(PacketWriter packet) {
        packet.uint8(SIP_CYCLE_MS).uint8(hostBaud).uint8(get(Setting.AUX1_BAUD));
        packet.uint16s(flag(model.equipment().hasGripper()), hasSonar(true)).uint8(hasSonar(false));
        packet.uint16s(get(Setting.LOW_BATTERY), get(Setting.REVCOUNT), model.watchdogMs())
                .uint8(0);
        packet.uint16s(get(Setting.STALLVAL), get(Setting.STALLCOUNT), get(Setting.JOYVEL), get(Setting.JOYRVEL));
    }

    /** ROTVELMAX to TRANSKI, fields 25 to 36. */
    private void writeMotion(PacketWriter packet) {
        packet.uint16s(speed(limits.rotation()), speed(limits.translation()));
        packet.uint16s(acceleration(limits.rotation()), deceleration(limits.rotation()));
        packet.uint16s(get(Setting.ROTKP), get(Setting.ROTKV), get(Setting.ROTKI));
        packet.uint16s(acceleration(limits.translation()), deceleration(limits.translation()));
        packet.uint16s(get(Setting.TRANSKP), get(Setting.TRANSKV), get(Setting.TRANSKI));
    }

    /** FRONTBUMPS to the charge threshold, fields 37 to 57. */
    private void writeAros(PacketWriter packet) {
        Equipment equipment = model.equipment();
        packet.uint8(model.frontBumpers()).uint8(model.rearBumpers());
        packet.uint8(equipment.charger()).uint8(sonarCycleMs);
        packet.uint8(AUTOBAUD_AUTOMATIC).uint8(flag(equipment.hasGyro())).uint16(get(Setting.DRIFTFACTOR));
        packet.uint8(get(Setting.AUX2_BAUD)).uint8(get(Setting.AUX3_BAUD));
        packet.uint16s(get(Setting.TICKSMM), get(Setting.SHUTDOWN)).text(VERSION);
        packet.uint16s(get(Setting.GYRO_CLOCKWISE), get(Setting.GYRO_COUNTERCLOCKWISE))
                .uint8(0);
        packet.uint16s(NO_SIDEWAYS_TOP, NO_SIDEWAYS_TOP, 0, 0, 0, 0);
    }

    /** PDB port to the gyro's firmware version, fields 58 to 67. */
    private void writeArcos(PacketWriter packet) {
        packet.uint8(0).uint16(GYRO_LIMIT_DEG_PER_SEC).uint8(Thermometer.SHUTDOWN_CELSIUS);
        packet.uint16(0).uint8(model.equipment().smartBatteries());
        packet.uint16s(LOW_CHARGE_PERCENT, SHUTDOWN_CHARGE_PERCENT).text(BOOT_LOADER);
        packet.int32(0).uint16(0);
    }

    private int get(Setting setting) {
        return settings.applyAsInt(setting);
    }

    private int hasSonar(boolean front) {
        return flag(model.hasSonars(front));
    }

    private static int flag(boolean set) {
        return set ? 1 : 0;
    }

    private static int speed(Limits limits) {
        return (int) Math.round(limits.speed());
    }

    private static int acceleration(Limits limits) {
        return (int) Math.round(limits.acceleration());
    }

    private static int deceleration(Limits limits) {
        return (int) Math.round(limits.deceleration());
    }
}
