package majic.pioneer.arcos;

/** The commands of a Pioneer with their numbers, arguments and units, under the manual's names (ARCOS sheet 6.1). */
public enum Command {
    /** Does nothing but restart the watchdog. */
    PULSE(0, Argument.NONE, ""),
    /** Starts the servers and the SIPs. */
    OPEN(1, Argument.INT, ""),
    /** Ends the session. */
    CLOSE(2, Argument.INT, ""),
    /** Motors on or off. */
    ENABLE(4, Argument.INT, "0 off, 1 on"),
    /** Acceleration when positive, deceleration when negative. */
    SETA(5, Argument.INT, "mm/s²"),
    /** Highest speed. */
    SETV(6, Argument.INT, "mm/s"),
    /** Odometry to zero. */
    SETO(7, Argument.NONE, ""),
    /** Drive a distance. */
    MOVE(8, Argument.INT, "mm"),
    /** Turn rate, the older twin of RVEL. */
    ROTATE(9, Argument.INT, "deg/s"),
    /** Highest turn rate. */
    SETRV(10, Argument.INT, "deg/s"),
    /** Speed. */
    VEL(11, Argument.INT, "mm/s"),
    /** Turn to a heading. */
    HEAD(12, Argument.INT, "deg"),
    /** Turn by an angle. */
    DHEAD(13, Argument.INT, "deg"),
    /** Tones: pairs of duration and tone. */
    SAY(15, Argument.STRING, "20 ms, MIDI note"),
    /** Joystick packets. */
    JOYINFO(17, Argument.INT, "0, 1, 2"),
    /** Asks for a CONFIG packet. */
    CONFIG(18, Argument.INT, ""),
    /** Encoder packets. */
    ENCODER(19, Argument.INT, "0, 1, 2"),
    /** Turn rate. */
    RVEL(21, Argument.INT, "deg/s"),
    /** Turn relative to the last heading set-point. */
    DCHEAD(22, Argument.INT, "deg"),
    /** Turning acceleration when positive, deceleration when negative. */
    SETRA(23, Argument.INT, "deg/s²"),
    /** Sonars on or off. */
    SONAR(28, Argument.INT, "0 off, 1 on"),
    /** Both channels to zero with the set deceleration. */
    STOP(29, Argument.NONE, ""),
    /** Digital outputs: states, mask. */
    DIGOUT(30, Argument.TWO_BYTES, "bits"),
    /** Wheel speeds: right, left. */
    VEL2(32, Argument.TWO_BYTES, "20 mm/s"),
    /** Gripper and lift. */
    GRIPPER(33, Argument.INT, ""),
    /** Which analog port the SIP shows. */
    ADSEL(35, Argument.INT, "port"),
    /** Value for GRIPPER 16 and 17. */
    GRIPPERVAL(36, Argument.INT, "20 ms"),
    /** Gripper packets. */
    GRIPREQUEST(37, Argument.INT, "0, 1, 2"),
    /** IO packets. */
    IOREQUEST(40, Argument.INT, "0, 1, 2"),
    /** Bytes to the AUX1 port. */
    TTY2(42, Argument.STRING, "bytes"),
    /** Reads the AUX1 port. */
    GETAUX(43, Argument.INT, "bytes"),
    /** Which bumpers stall the robot. */
    BUMPSTALL(44, Argument.INT, "0 none, 1 front, 2 rear, 3 both"),
    /** Whether the joystick drives during a session. */
    JOYDRIVE(47, Argument.INT, "0, 1"),
    /** Sonar firing period. */
    SONARCYCLE(48, Argument.INT, "ms"),
    /** Speed of the port to the client. */
    HOSTBAUD(50, Argument.INT, "code"),
    /** Stops as hard as possible. */
    ESTOP(55, Argument.NONE, ""),
    /** Whether the STOP button stalls. */
    E_STALL(56, Argument.INT, "0, 1"),
    /** Quick stop. */
    QSTOP(57, Argument.NONE, ""),
    /** Gyro packets. */
    GYRO(58, Argument.INT, "0, 1"),
    /** Battery packets. */
    BATTERYINFO(62, Argument.INT, "0, 1, 2"),
    /** Docking mechanism. */
    CHARGE(68, Argument.INT, "0, 1"),
    /** Mutes the buzzer. */
    SOUNDTOG(92, Argument.INT, "0, 1"),
    /** Pretends a battery voltage. */
    BATTEST(250, Argument.INT, "0.1 V");

    /** What follows a command's number. */
    public enum Argument {
        /** Nothing. */
        NONE,
        /** A whole number of 16 bits and a sign. */
        INT,
        /** Two bytes in place of a number. */
        TWO_BYTES,
        /** A length and bytes. */
        STRING
    }

    private final int number;
    private final Argument argument;
    private final String unit;

    Command(int number, Argument argument, String unit) {
        this.number = number;
        this.argument = argument;
        this.unit = unit;
    }

    /** Its number, the type of its packet. */
    public int number() {
        return number;
    }

    /** What the argument counts; empty where it counts nothing. */
    public String unit() {
        return unit;
    }

    /**
     * The packet without an argument.
     *
     * @throws IllegalArgumentException if the command takes one
     */
    public byte[] packet() {
        require(Argument.NONE);
        return Frame.bare(number);
    }

    /**
     * The packet with a whole number, of the unit and range the sheet gives.
     *
     * @throws IllegalArgumentException if the command takes none, or the magnitude does not fit 16 bits
     */
    public byte[] packet(int value) {
        require(Argument.INT);
        return Frame.number(number, value);
    }

    /**
     * The packet with two bytes.
     *
     * @throws IllegalArgumentException if the command takes none
     */
    public byte[] packet(int low, int high) {
        require(Argument.TWO_BYTES);
        return Frame.pair(number, low, high);
    }

    /**
     * The packet with a length and that many bytes.
     *
     * @throws IllegalArgumentException if the command takes none, or the packet would be longer than 200 bytes
     */
    public byte[] packet(byte[] text) {
        require(Argument.STRING);
        return Frame.string(number, text);
    }

    private void require(Argument given) {
        if (given != argument) {
            throw new IllegalArgumentException(this + " takes " + argument + ", not " + given);
        }
    }
}
