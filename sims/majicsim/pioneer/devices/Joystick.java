package majicsim.pioneer.devices;

import majicsim.pioneer.packet.PacketWriter;

/**
 * The joystick at the robot's side. Pushes are -1 to 1, right and ahead positive; on the wire 0 to 1023 (ARCOS sheet
 * 11.4).
 */
public final class Joystick {
    private static final int CENTRE = 512;
    private static final int FULL_PUSH = 511;
    private static final int FULL_THROTTLE = 1023;

    private double right;
    private double ahead;
    private double throttle = 1;
    private boolean fire;
    private boolean second;

    public void push(double newRight, double newAhead) {
        right = clamp(newRight, -1);
        ahead = clamp(newAhead, -1);
    }

    /** 0 to 1. */
    public void throttle(double share) {
        throttle = clamp(share, 0);
    }

    public void buttons(boolean firePressed, boolean secondPressed) {
        fire = firePressed;
        second = secondPressed;
    }

    /** Whether the button is held that makes the robot drive. */
    public boolean isFiring() {
        return fire;
    }

    public boolean isAnyButtonPressed() {
        return fire || second;
    }

    /** How fast ahead, -1 to 1 of the most. */
    public double drive() {
        return ahead * throttle;
    }

    /** How fast to the left, -1 to 1 of the most. */
    public double turn() {
        return -right * throttle;
    }

    public byte[] toBytes() {
        return new PacketWriter(0xF8)
                .uint8(fire ? 1 : 0)
                .uint8(second ? 1 : 0)
                .uint16s(raw(right), raw(ahead), (int) Math.round(throttle * FULL_THROTTLE))
                .toBytes();
    }

    private static int raw(double push) {
        return CENTRE + (int) Math.round(push * FULL_PUSH);
    }

    private static double clamp(double value, double least) {
        return Math.max(least, Math.min(1, value));
    }
}
