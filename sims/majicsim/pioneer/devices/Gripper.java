package majicsim.pioneer.devices;

import majicsim.pioneer.packet.PacketWriter;

/**
 * The gripper: paddles and lift, each taking its real time (ARCOS sheet 11.5). The sheet does not state which switch is
 * which bit; here 0 and 1 are the ends of paddles and lift, 2 and 3 the outer and inner light beam, 4 and 5 left and
 * right paddle pressed.
 */
public final class Gripper {
    private static final int TYPE_NONE = 0;
    private static final int TYPE_GENERAL_IO = 2;
    private static final double PADDLES_SECONDS = 2;
    private static final double LIFT_SECONDS = 4;
    private static final double SECONDS_PER_UNIT = 0.02;
    /** How far open an object keeps the paddles. */
    private static final double GRASPED = 0.4;

    private final boolean fitted;
    private final Axis paddles = new Axis(PADDLES_SECONDS, 0);
    private final Axis lift = new Axis(LIFT_SECONDS, 1);
    private boolean hasObject;
    private int order;
    private int graspTime;

    /** Paddles closed, lift up. */
    Gripper(boolean fitted) {
        this.fitted = fitted;
    }

    /** GRIPPER; unknown arguments have no effect. */
    public void order(int number) {
        if (!fitted) {
            return;
        }
        order = number;
        switch (number) {
            case 1 -> paddles.up();
            case 2 -> paddles.down();
            case 3 -> paddles.stop();
            case 4 -> lift.up();
            case 5 -> lift.down();
            case 6 -> lift.stop();
            case 7 -> store();
            case 8 -> deploy();
            case 15 -> halt();
            default -> {} // 16 and 17 wait for their value
        }
    }

    /** GRIPPERVAL, for the GRIPPER 16 or 17 before it. */
    public void value(int units) {
        if (order == 16) {
            graspTime = units;
        } else if (order == 17) {
            lift.run(units * SECONDS_PER_UNIT);
        }
        order = 0;
    }

    /** Sets whether an object is between the paddles. */
    public void put(boolean object) {
        hasObject = object;
    }

    void halt() {
        paddles.stop();
        lift.stop();
    }

    boolean isMoving() {
        return paddles.isMoving() || lift.isMoving();
    }

    void step(double seconds) {
        paddles.step(seconds, narrowest());
        lift.step(seconds, 0);
    }

    /** The byte in the SIP: open, closed, paddles moving, -, lift up, lift down, lift moving. */
    public int state() {
        if (!fitted) {
            return 0;
        }
        return bit(0, isOpen())
                | bit(1, isClosed())
                | bit(2, paddles.isMoving())
                | bit(4, lift.position() >= 1)
                | bit(5, lift.position() <= 0)
                | bit(6, lift.isMoving());
    }

    public byte[] toBytes() {
        return new PacketWriter(0xE0)
                .uint8(fitted ? TYPE_GENERAL_IO : TYPE_NONE)
                .uint8(fitted ? switches() : 0)
                .uint8(graspTime)
                .toBytes();
    }

    private int switches() {
        boolean pressed = hasObject && isClosed();
        return bit(0, isOpen() || isClosed())
                | bit(1, lift.position() >= 1 || lift.position() <= 0)
                | bit(2, hasObject)
                | bit(3, hasObject)
                | bit(4, pressed)
                | bit(5, pressed);
    }

    private void store() {
        paddles.down();
        lift.up();
    }

    private void deploy() {
        paddles.up();
        lift.down();
    }

    private boolean isOpen() {
        return paddles.position() >= 1;
    }

    private boolean isClosed() {
        return paddles.position() <= narrowest();
    }

    private double narrowest() {
        return hasObject ? GRASPED : 0;
    }

    private static int bit(int number, boolean set) {
        return set ? 1 << number : 0;
    }
}
