package majic.pioneer.arcos;

/**
 * The commands of a Pioneer with their numbers, arguments, units and ranges, under the manual's names (ARCOS sheet 6.1).
 * Those of arms (70 to 81) and of simulators (6.2) are left out.
 *
 * <p>Of rarely needed commands the sheet lists only the numbers. Their arguments are taken here from commands of the same
 * kind, and their names may be ours; check the robot's own manual before sending one.
 */
public enum ArcosCommand {
    /** Only restarts the watchdog. */
    PULSE(0, CommandArgument.none()),
    /** Starts the servers and the SIPs; 1 as ARIA sends it. */
    OPEN(1, CommandArgument.number(0, 1, "")),
    /** Ends the session; 1 as ARIA sends it. */
    CLOSE(2, CommandArgument.number(0, 1, "")),
    /** The order in which sonar discs fire. */
    POLLING(3, CommandArgument.text(192, "sonar discs")),
    /** Motors on or off. */
    ENABLE(4, CommandArgument.onOff()),
    /** Acceleration when positive, deceleration when negative. */
    SETA(5, CommandArgument.signed("mm/s²")),
    /** Highest speed. */
    SETV(6, CommandArgument.size("mm/s")),
    /** Odometry to zero. */
    SETO(7, CommandArgument.none()),
    /** Drive a distance; the manual advises no more than 5000 mm at once. */
    MOVE(8, CommandArgument.signed("mm")),
    /** Turn rate, as RVEL, older. */
    ROTATE(9, CommandArgument.signed("deg/s")),
    /** Highest turn rate. */
    SETRV(10, CommandArgument.size("deg/s")),
    /** Speed. */
    VEL(11, CommandArgument.signed("mm/s")),
    /** Turn to a heading, the shorter way round. */
    HEAD(12, CommandArgument.number(-360, 360, "deg")),
    /** Turn by an angle. */
    DHEAD(13, CommandArgument.signed("deg")),
    /** Up to 20 tones, each a duration and a tone; 0 is silence. */
    SAY(15, CommandArgument.text(40, "pairs of 20 ms and MIDI note")),
    /** Joystick packets. */
    JOYINFO(17, CommandArgument.request()),
    /** Requests a CONFIG packet; 1 as ARIA sends it. */
    CONFIG(18, CommandArgument.number(0, 1, "")),
    /** Encoder packets. */
    ENCODER(19, CommandArgument.request()),
    /** Highest turn rate in one direction, by the sign. */
    SETRVDIR(20, CommandArgument.signed("deg/s")),
    /** Turn rate. */
    RVEL(21, CommandArgument.signed("deg/s")),
    /** Turn relative to the last heading set-point. */
    DCHEAD(22, CommandArgument.signed("deg")),
    /** Turning acceleration when positive, deceleration when negative. */
    SETRA(23, CommandArgument.signed("deg/s²")),
    /** Sonars on or off. */
    SONAR(28, CommandArgument.size("0 off, 1 on, higher bits: which array")),
    /** Both channels to zero with the set deceleration. */
    STOP(29, CommandArgument.none()),
    /** Digital outputs: states, mask. */
    DIGOUT(30, CommandArgument.twoBytes(0, 255, "states, mask")),
    /** Wheel speeds: right, left. */
    VEL2(32, CommandArgument.twoBytes(-128, 127, "20 mm/s")),
    /** Gripper and lift. */
    GRIPPER(33, CommandArgument.number(0, 17, "ARCOS sheet 11.5")),
    /** Which analog port the SIP shows. */
    ADSEL(35, CommandArgument.number(0, 255, "port")),
    /** Value for GRIPPER 16 and 17. */
    GRIPPERVAL(36, CommandArgument.signed("20 ms")),
    /** Gripper packets. */
    GRIPREQUEST(37, CommandArgument.request()),
    /** Correction of the gyro clockwise. */
    GYROCALCW(38, CommandArgument.size("")),
    /** Correction of the gyro counterclockwise. */
    GYROCALCCW(39, CommandArgument.size("")),
    /** IO packets. */
    IOREQUEST(40, CommandArgument.request()),
    /** Bytes to serial port AUX1. */
    TTY2(42, CommandArgument.text(192, "bytes")),
    /** Reads serial port AUX1. */
    GETAUX(43, CommandArgument.number(0, 200, "bytes, 0 flush")),
    /** Which bumpers stall the robot. */
    BUMPSTALL(44, CommandArgument.number(0, 3, "0 none, 1 front, 2 rear, 3 both")),
    /** Commands for the tilting compass. */
    TCM2(45, CommandArgument.size("")),
    /** Whether the plugged-in joystick drives during a session. */
    JOYDRIVE(47, CommandArgument.onOff()),
    /** Sonar firing period. */
    SONARCYCLE(48, CommandArgument.size("ms")),
    /** Whether a lamp blinks as the robot moves. */
    MOVINGBLINK(49, CommandArgument.onOff()),
    /** Speed of the port to the client. */
    HOSTBAUD(50, CommandArgument.number(0, 4, "0 9600, 1 19200, 2 38400, 3 57600, 4 115200 baud")),
    /** Speed of serial port AUX1. */
    AUX1BAUD(51, CommandArgument.number(0, 4, "as HOSTBAUD")),
    /** Speed of serial port AUX2. */
    AUX2BAUD(52, CommandArgument.number(0, 4, "as HOSTBAUD")),
    /** Speed of serial port AUX3. */
    AUX3BAUD(53, CommandArgument.number(0, 4, "as HOSTBAUD")),
    /** Stops as hard as possible. */
    ESTOP(55, CommandArgument.none()),
    /** Whether the STOP button stalls and disables the motors. */
    E_STALL(56, CommandArgument.onOff()),
    /** Quick stop. */
    QSTOP(57, CommandArgument.none()),
    /** Gyro packets. */
    GYRO(58, CommandArgument.onOff()),
    /** Bytes to serial port AUX3. */
    TTY4(60, CommandArgument.text(192, "bytes")),
    /** Reads serial port AUX3. */
    GETAUX3(61, CommandArgument.number(0, 200, "bytes, 0 flush")),
    /** Battery packets. */
    BATTERYINFO(62, CommandArgument.request()),
    /** Calibrates the compass. */
    CALCOMP(65, CommandArgument.size("")),
    /** Bytes to serial port AUX2. */
    TTY3(66, CommandArgument.text(192, "bytes")),
    /** Reads serial port AUX2. */
    GETAUX2(67, CommandArgument.number(0, 200, "bytes, 0 flush")),
    /** Docking mechanism. */
    CHARGE(68, CommandArgument.number(0, 1, "0 release, 1 deploy")),
    /** Proportional gain of turning. */
    ROTKP(82, CommandArgument.size("")),
    /** Derivative gain of turning. */
    ROTKV(83, CommandArgument.size("")),
    /** Integral gain of turning. */
    ROTKI(84, CommandArgument.size("")),
    /** Proportional gain of driving. */
    TRANSKP(85, CommandArgument.size("")),
    /** Derivative gain of driving. */
    TRANSKV(86, CommandArgument.size("")),
    /** Integral gain of driving. */
    TRANSKI(87, CommandArgument.size("")),
    /** Difference of the encoders over a full turn. */
    REVCOUNT(88, CommandArgument.size("ticks")),
    /** By how much one wheel is larger. */
    DRIFTFACTOR(89, CommandArgument.signed("")),
    /** Mutes the buzzer. */
    SOUNDTOG(92, CommandArgument.number(0, 1, "0 mute, 1 sound")),
    /** Encoder ticks per mm. */
    TICKSMM(93, CommandArgument.size("ticks")),
    /** A power switch; its load depends on the model. */
    POWER95(95, CommandArgument.onOff()),
    /** A power switch. */
    POWER96(96, CommandArgument.onOff()),
    /** A power switch. */
    POWER97(97, CommandArgument.onOff()),
    /** A power switch. */
    POWER98(98, CommandArgument.onOff()),
    /** Speed sideways, for robots that can. */
    LATVEL(110, CommandArgument.signed("mm/s")),
    /** Acceleration sideways when positive, deceleration when negative. */
    LATACCEL(113, CommandArgument.signed("mm/s²")),
    /** Packets of the accelerometer. */
    ACCELINFO(123, CommandArgument.request()),
    /** Packets of the motors' torque. */
    TORQUEINFO(124, CommandArgument.request()),
    /** A power switch. */
    POWER125(125, CommandArgument.onOff()),
    /** A power switch. */
    POWER126(126, CommandArgument.onOff()),
    /** A power switch. */
    POWER127(127, CommandArgument.onOff()),
    /** A power switch. */
    POWER128(128, CommandArgument.onOff()),
    /** A power switch. */
    POWER129(129, CommandArgument.onOff()),
    /** Packets of the heading. */
    HEADINGINFO(149, CommandArgument.request()),
    /** Whether the turn rate is controlled by the gyro. */
    ROTVEL_CLOSEDLOOP_ENABLE(150, CommandArgument.onOff()),
    /** Simulates a battery voltage. */
    BATTEST(250, CommandArgument.number(0, 255, "0.1 V, 0 the real one")),
    /** Restarts the controller. Ends the vendor's simulator. */
    RESET(253, CommandArgument.none()),
    /** Puts the controller into its maintenance mode. Ends the vendor's simulator. */
    MAINTENANCE(255, CommandArgument.none());

    private final int number;
    private final CommandArgument argument;

    ArcosCommand(int number, CommandArgument argument) {
        this.number = number;
        this.argument = argument;
    }

    /** Its number, the type of its packet. */
    public int number() {
        return number;
    }

    /** The kind and range of its argument. */
    public CommandArgument argument() {
        return argument;
    }

    /**
     * The packet without an argument.
     *
     * @throws IllegalArgumentException if the command takes one
     */
    public byte[] packet() {
        argument.check(this, CommandArgument.Kind.NONE);
        return FrameEncoder.bare(number);
    }

    /**
     * The packet with a whole number; its sign travels in the type byte.
     *
     * @param value in the unit and range of {@link #argument()}
     * @throws IllegalArgumentException if the command takes no such argument, or the value is out of range
     */
    public byte[] packet(int value) {
        argument.check(this, CommandArgument.Kind.INT, value);
        return FrameEncoder.number(number, value);
    }

    /**
     * The packet with two bytes.
     *
     * @param low the first on the wire
     * @param high the second
     * @throws IllegalArgumentException if the command takes no such argument, or the value is out of range
     */
    public byte[] packet(int low, int high) {
        argument.check(this, CommandArgument.Kind.TWO_BYTES, low, high);
        return FrameEncoder.pair(number, low, high);
    }

    /**
     * The packet with a length and that many bytes.
     *
     * @throws IllegalArgumentException if the command takes no bytes, or fewer
     */
    public byte[] packet(byte[] text) {
        argument.check(this, CommandArgument.Kind.STRING, text.length);
        return FrameEncoder.string(number, text);
    }
}
