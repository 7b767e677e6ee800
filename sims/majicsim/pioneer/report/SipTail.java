package majicsim.pioneer.report;

import majicsim.pioneer.board.Board;
import majicsim.pioneer.devices.Devices;
import majicsim.pioneer.devices.UserPort;
import majicsim.pioneer.model.Generation;
import majicsim.pioneer.packet.PacketWriter;

/**
 * The part of a SIP after the sonar readings, more of it with each generation of firmware (ARCOS sheet 8).
 *
 * @param generation the firmware, which determines where it ends
 * @param gripper its state, as sheet 11.5
 * @param analogPort the port chosen with ADSEL
 * @param analog that port's voltage, 255 for 5 V
 * @param digitalIn inputs, active low
 * @param digitalOut outputs
 * @param chargeState 0 not charging, 1 bulk, 2 overcharge, 3 float
 * @param faults 0 if there is none
 * @param celsius temperature
 * @param chargePercent state of charge, 0 for unknown
 * @param clockMicros since the controller started
 */
record SipTail(
        Generation generation,
        int gripper,
        int analogPort,
        int analog,
        int digitalIn,
        int digitalOut,
        int chargeState,
        int faults,
        int celsius,
        int chargePercent,
        int clockMicros) {
    /** What the vendor's simulator sends. */
    static final int NO_TEMPERATURE = -127;

    private static final int CHARGE_NOT_KNOWN = 0;
    private static final int NOT_SIDEWAYS = 0;
    private static final int NO_FLAGS_3 = 0;

    static SipTail of(Board board) {
        Devices devices = board.devices();
        UserPort port = devices.userPort();
        Generation generation = board.model().equipment().generation();
        boolean newest = generation == Generation.ARCOS;
        return new SipTail(
                generation,
                devices.gripper().state(),
                port.shownPort(),
                port.shownAnalog(),
                port.digitalIn(),
                port.digitalOut(),
                devices.charger().state(),
                devices.thermometer().faults(),
                newest ? devices.thermometer().celsius() : NO_TEMPERATURE,
                newest ? devices.battery().percent() : CHARGE_NOT_KNOWN,
                board.clockMicros());
    }

    void write(PacketWriter packet, int batteryTenthVolts, int turnRate) {
        packet.uint8(gripper).uint8(analogPort).uint8(analog).uint8(digitalIn).uint8(digitalOut);
        if (generation.isAtLeast(Generation.AROS)) {
            packet.uint16(batteryTenthVolts).uint8(chargeState);
            packet.uint16s(turnRate, faults, NOT_SIDEWAYS);
            packet.uint8(celsius).uint8(chargePercent);
        }
        if (generation.isAtLeast(Generation.ARCOS)) {
            packet.int32(clockMicros).int32(NO_FLAGS_3);
        }
    }
}
