package majic.pioneer.arcos;

/**
 * The fields of a SIP in their order, under the manual's names (ARCOS sheet 8). The sonar readings come between
 * {@link #COMPASS} and {@link #GRIP_STATE}; older firmware sends fewer of the fields behind them.
 */
public enum SipField {
    /** The packet's own type: 0x32 stationary, 0x33 moving; not reliable. */
    TYPE(0),
    /** Odometry counter, 16 bits. */
    X_POS(2),
    /** Odometry counter, 16 bits. */
    Y_POS(2),
    /** Heading, 4096 units a turn, or 1024 on the oldest models. */
    TH_POS(-2),
    /** Left wheel. */
    L_VEL(-2),
    /** Right wheel. */
    R_VEL(-2),
    /** 0.1 V; 25.5 V at most. */
    BATTERY(1),
    /** Bit 0 left motor stalled, bits 1–7 rear bumper segments. */
    STALL_REAR(1),
    /** Bit 0 right motor stalled, bits 1–7 front bumper segments. */
    STALL_FRONT(1),
    /** Set-point of the heading servo. */
    CONTROL(-2),
    /** Bits of ARCOS sheet 8.1. */
    FLAGS(2),
    /** In 2°, 0 for none. */
    COMPASS(1),
    /** Gripper, bits. */
    GRIP_STATE(1),
    /** Which port {@link #ANALOG} is of. */
    ANALOG_PORT(1),
    /** 0 to 255 for 0 to 5 V. */
    ANALOG(1),
    /** Digital inputs, bits. */
    DIG_IN(1),
    /** Digital outputs, bits. */
    DIG_OUT(1),
    /** True voltage, 0.1 V. */
    BATTERY_TENTHS(2),
    /** 255 unknown, 0 not charging, 1 bulk, 2 overcharge, 3 float, 4 balance. */
    CHARGE_STATE(1),
    /** 0.1 deg/s, counterclockwise positive. */
    TURN_RATE_TENTHS(-2),
    /** 0 = fine. */
    FAULT_FLAGS(2),
    /** mm/s; 0 on robots with two driven wheels. */
    SIDEWAYS_SPEED(-2),
    /** °C; −128 and −127 for none. */
    TEMPERATURE(-1),
    /** 0 = not known. */
    CHARGE_PERCENT(-1),
    /** The controller's clock, µs, 32 bits. */
    CLOCK_MICROS(4),
    /** Bits of the newest firmware. */
    FLAGS3(4);

    final int bytes;
    final boolean signed;

    /** A field of so many bytes; with a minus sign if it has one itself. */
    SipField(int bytes) {
        this.bytes = Math.abs(bytes);
        this.signed = bytes < 0;
    }
}
