package majic.pioneer.arcos;

/** The fields of a CONFIG packet in their order, under the manual's names (ARCOS sheet 10: fields 1 to 67). */
public enum ConfigField {
    /** {@code Pioneer} for nearly all. */
    CLASS(Kind.STRING),
    /** The model. */
    SUBCLASS(Kind.STRING),
    /** Serial number; {@code SIM} is the vendor's simulator. */
    SERNUM(Kind.STRING),
    /** Whether it has four motors; obsolete. */
    FOURMOTS(Kind.UBYTE),
    /** What the robot can never exceed, deg/s. */
    ROTVELTOP(Kind.UINT),
    /** What the robot can never exceed, mm/s. */
    TRANSVELTOP(Kind.UINT),
    /** What the robot can never exceed, deg/s². */
    ROTACCTOP(Kind.UINT),
    /** What the robot can never exceed, mm/s². */
    TRANSACCTOP(Kind.UINT),
    /** Most that the motors are given, PWM steps. */
    PWMMAX(Kind.UINT),
    /** The owner's name for it. */
    NAME(Kind.STRING),
    /** From one SIP to the next, ms. */
    SIPCYCLE(Kind.UBYTE),
    /** Speed of the port to the client, code of HOSTBAUD. */
    HOSTBAUD(Kind.UBYTE),
    /** Speed of serial port AUX1, code. */
    AUX1BAUD(Kind.UBYTE),
    /** Whether there is a gripper. */
    GRIPPER(Kind.UINT),
    /** Whether there is a front sonar array. */
    FRONTSONAR(Kind.UINT),
    /** Whether there is a rear sonar array; one byte, unlike its neighbours. */
    REARSONAR(Kind.UBYTE),
    /** Battery voltage at which it sounds an alarm, 0.1 V. */
    LOWBATTERY(Kind.UINT),
    /** Difference of the encoders over a full turn, ticks. */
    REVCOUNT(Kind.UINT),
    /** After how long without a packet it stops, ms; 0 for never. */
    WATCHDOG(Kind.UINT),
    /** Whether it sends an alternative SIP. */
    P2MPACS(Kind.UBYTE),
    /** PWM from which on a stationary motor counts as stalled. */
    STALLVAL(Kind.UINT),
    /** How long motors rest after a stall, ms. */
    STALLCOUNT(Kind.UINT),
    /** Speed with the joystick pushed all the way, mm/s. */
    JOYVEL(Kind.UINT),
    /** Turn rate with the joystick pushed all the way, deg/s. */
    JOYRVEL(Kind.UINT),
    /** Highest turn rate as set now, deg/s. */
    ROTVELMAX(Kind.UINT),
    /** Highest speed as set now, mm/s. */
    TRANSVELMAX(Kind.UINT),
    /** As set now, deg/s². */
    ROTACC(Kind.UINT),
    /** As set now, deg/s². */
    ROTDECEL(Kind.UINT),
    /** Proportional gain of turning. */
    ROTKP(Kind.UINT),
    /** Derivative gain of turning. */
    ROTKV(Kind.UINT),
    /** Integral gain of turning. */
    ROTKI(Kind.UINT),
    /** As set now, mm/s². */
    TRANSACC(Kind.UINT),
    /** As set now, mm/s². */
    TRANSDECEL(Kind.UINT),
    /** Proportional gain of driving. */
    TRANSKP(Kind.UINT),
    /** Derivative gain of driving. */
    TRANSKV(Kind.UINT),
    /** Integral gain of driving. */
    TRANSKI(Kind.UINT),
    /** Segments of the front bumper; 0 for none. */
    FRONTBUMPS(Kind.UBYTE),
    /** Segments of the rear bumper; 0 for none. */
    REARBUMPS(Kind.UBYTE),
    /** Docking charger: 1 Pioneer 3, 2 PowerBot, 0 none. */
    CHARGER(Kind.UBYTE),
    /** Time for one sonar disc, ms. */
    SONARCYCLE(Kind.UBYTE),
    /** 1 the port's speed can change, 2 it changes by itself. */
    AUTOBAUD(Kind.UBYTE),
    /** 0 no gyro, 1 one that the client reads, 2 and more one that the controller reads itself (as ARIA takes it). */
    HASGYRO(Kind.UBYTE),
    /** By how much one wheel is larger. */
    DRIFTFACTOR(Kind.INT),
    /** Speed of serial port AUX2, code. */
    AUX2BAUD(Kind.UBYTE),
    /** Speed of serial port AUX3, code. */
    AUX3BAUD(Kind.UBYTE),
    /** Encoder ticks per mm. */
    TICKSMM(Kind.UINT),
    /** Battery voltage at which it switches itself off, 0.1 V. */
    SHUTDOWN(Kind.UINT),
    /** Version of the firmware. */
    FIRMWARE(Kind.STRING),
    /** Correction of the gyro clockwise. */
    GYROCW(Kind.UINT),
    /** Correction of the gyro counterclockwise. */
    GYROCCW(Kind.UINT),
    /** How old the odometry in a SIP is, ms. */
    KINEMATICSDELAY(Kind.UBYTE),
    /** Sideways, what the robot can never exceed, mm/s. */
    LATVELTOP(Kind.UINT),
    /** Sideways, what the robot can never exceed, mm/s². */
    LATACCTOP(Kind.UINT),
    /** Sideways, as set now, mm/s. */
    LATVELMAX(Kind.UINT),
    /** Sideways, as set now, mm/s². */
    LATACC(Kind.UINT),
    /** Sideways, as set now, mm/s². */
    LATDECEL(Kind.UINT),
    /** Battery voltage below which it charges. */
    CHARGETHRESHOLD(Kind.UINT),
    /** Port of the power distribution board. */
    PDBPORT(Kind.UBYTE),
    /** Fastest turn the gyro follows. */
    GYRORATELIMIT(Kind.UINT),
    /** Temperature at which it switches itself off, °C; −128 for never. */
    HIGHTEMP(Kind.SBYTE),
    /** What is powered at start, bits. */
    POWERBITS(Kind.UINT),
    /** Kind of battery. */
    BATTERYTYPE(Kind.UBYTE),
    /** Charge at which it sounds an alarm, percent. */
    LOWCHARGE(Kind.UINT),
    /** Charge at which it switches itself off, percent. */
    SHUTDOWNCHARGE(Kind.UINT),
    /** Version of the boot loader. */
    BOOTLOADER(Kind.STRING),
    /** Bits of the newest firmware. */
    CONFIGFLAGS(Kind.UINT32),
    /** Version of the gyro's own firmware. */
    GYROFIRMWARE(Kind.INT);

    private final Kind kind;

    /** How a field is written. */
    private enum Kind {
        STRING,
        UBYTE,
        SBYTE,
        UINT,
        INT,
        UINT32
    }

    ConfigField(Kind kind) {
        this.kind = kind;
    }

    /** Whether it is text and not a number. */
    public boolean isText() {
        return kind == Kind.STRING;
    }

    /** The value of a field that did not come. */
    Object missing() {
        return isText() ? "" : this == HIGHTEMP ? -128L : 0L;
    }

    /** The next field of a packet: text, or a number as a {@code Long}. */
    Object read(FieldReader fields) {
        if (fields.remaining() == 0) {
            return missing();
        }
        return switch (kind) {
            case STRING -> fields.string();
            case UBYTE -> (long) fields.ubyte();
            case SBYTE -> (long) fields.sbyte();
            case UINT -> (long) fields.uint();
            case INT -> (long) fields.sint();
            case UINT32 -> fields.uint32();
        };
    }
}
