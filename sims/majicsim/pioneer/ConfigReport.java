package majicsim.pioneer;

/**
 * The CONFIG packet (ARCOS sheet 10), fields 1 to 57. Serial number and version tell clients that this is a simulator.
 *
 * @param robotName the owner's name for the robot
 * @param model class, subclass, sonar and bumpers
 * @param tops what the limits can be set to
 * @param limits what they are
 * @param sonarCycleMs the sonar's firing period, 0 to 255
 * @param ticksPerMm encoder ticks, 0 if not known
 */
record ConfigReport(
        String robotName,
        PioneerModel model,
        MotionLimits tops,
        MotionLimits limits,
        int sonarCycleMs,
        int ticksPerMm) {
    static final int SIP_CYCLE_MS = 100;
    static final int WATCHDOG_MS = 2000;

    private static final int TYPE = 0x20;
    private static final String SERIAL_NUMBER = "SIM";
    private static final String VERSION = "S.0";
    private static final int PWM_MAX = 400;
    private static final int AUTOBAUD_AUTOMATIC = 2;
    private static final int NO_SIDEWAYS_TOP = 9999;

    byte[] toBytes() {
        PacketWriter packet = new PacketWriter(TYPE);
        packet.text(model.className()).text(model.subclass()).text(SERIAL_NUMBER);
        packet.uint8(0).uint16s(speed(tops.rotation()), speed(tops.translation()));
        packet.uint16s(acceleration(tops.rotation()), acceleration(tops.translation()), PWM_MAX);
        packet.text(robotName);
        writeEquipment(packet);
        writeMotion(packet);
        writeRest(packet);
        return packet.toBytes();
    }

    /** SIPCYCLE to JOYRVEL, fields 11 to 24. */
    private void writeEquipment(PacketWriter packet) {
        packet.uint8(SIP_CYCLE_MS).uint8(0).uint8(0);
        packet.uint16s(0, hasSonar(0)).uint8(hasSonar(1));
        packet.uint16s(0, 0, WATCHDOG_MS).uint8(0);
        packet.uint16s(0, 0, 0, 0);
    }

    /** ROTVELMAX to TRANSKI, fields 25 to 36. */
    private void writeMotion(PacketWriter packet) {
        packet.uint16s(speed(limits.rotation()), speed(limits.translation()));
        packet.uint16s(acceleration(limits.rotation()), deceleration(limits.rotation()), 0, 0, 0);
        packet.uint16s(acceleration(limits.translation()), deceleration(limits.translation()), 0, 0, 0);
    }

    /** FRONTBUMPS to the charge threshold, fields 37 to 57. */
    private void writeRest(PacketWriter packet) {
        packet.uint8(model.frontBumpers()).uint8(model.rearBumpers()).uint8(0).uint8(sonarCycleMs);
        packet.uint8(AUTOBAUD_AUTOMATIC).uint8(0).uint16(0).uint8(0).uint8(0);
        packet.uint16s(ticksPerMm, 0).text(VERSION);
        packet.uint16s(0, 0).uint8(0);
        packet.uint16s(NO_SIDEWAYS_TOP, NO_SIDEWAYS_TOP, 0, 0, 0, 0);
    }

    private int hasSonar(int array) {
        return model.hasSonarArray(array) ? 1 : 0;
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
