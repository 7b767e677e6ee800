package majic.pioneer.arcos;

import java.util.Arrays;

/**
 * The commands of a Pioneer with their numbers, arguments, units and ranges, under the manual's names (ARCOS sheet
 * 6.1). Those of arms (70 to 81) are left out, and those of simulators (6.2) but for the laser.
 *
 * <p>Of rarely needed commands the sheet lists only the numbers. Their arguments are taken here from commands of the
 * same kind, and their names may be ours; check the robot's own manual before sending one.
 */
public enum ArcosCommand {
    /** Only restarts the watchdog. */
    PULSE(0, Argument.none()),
    /** Starts the servers and the SIPs; 1 as ARIA sends it. */
    OPEN(1, Argument.number(0, 1, "")),
    /** Ends the session; 1 as ARIA sends it. */
    CLOSE(2, Argument.number(0, 1, "")),
    /** The order in which sonar discs fire. */
    POLLING(3, Argument.text(192, "sonar discs")),
    /** Motors on or off. */
    ENABLE(4, Argument.onOff()),
    /** Acceleration when positive, deceleration when negative. */
    SETA(5, Argument.signed("mm/s²")),
    /** Highest speed. */
    SETV(6, Argument.size("mm/s")),
    /** Odometry to zero. */
    SETO(7, Argument.none()),
    /** Drive a distance; the manual advises no more than 5000 mm at once. */
    MOVE(8, Argument.signed("mm")),
    /** Turn rate, as RVEL, older. */
    ROTATE(9, Argument.signed("deg/s")),
    /** Highest turn rate. */
    SETRV(10, Argument.size("deg/s")),
    /** Speed. */
    VEL(11, Argument.signed("mm/s")),
    /** Turn to a heading, the shorter way round. */
    HEAD(12, Argument.number(-360, 360, "deg")),
    /** Turn by an angle. */
    DHEAD(13, Argument.signed("deg")),
    /** Up to 20 tones, each a duration and a tone; 0 is silence. */
    SAY(15, Argument.text(40, "pairs of 20 ms and MIDI note")),
    /** Joystick packets. */
    JOYINFO(17, Argument.request()),
    /** Requests a CONFIG packet; 1 as ARIA sends it. */
    CONFIG(18, Argument.number(0, 1, "")),
    /** Encoder packets. */
    ENCODER(19, Argument.request()),
    /** Highest turn rate in one direction, by the sign. */
    SETRVDIR(20, Argument.signed("deg/s")),
    /** Turn rate. */
    RVEL(21, Argument.signed("deg/s")),
    /** Turn relative to the last heading set-point. */
    DCHEAD(22, Argument.signed("deg")),
    /** Turning acceleration when positive, deceleration when negative. */
    SETRA(23, Argument.signed("deg/s²")),
    /** Sonars on or off. */
    SONAR(28, Argument.size("0 off, 1 on, higher bits: which array")),
    /** Both channels to zero with the set deceleration. */
    STOP(29, Argument.none()),
    /** Digital outputs: states, mask. */
    DIGOUT(30, Argument.twoBytes(0, 255, "states, mask")),
    /** Wheel speeds: right, left. */
    VEL2(32, Argument.twoBytes(-128, 127, "20 mm/s")),
    /** Gripper and lift. */
    GRIPPER(33, Argument.number(0, 17, "ARCOS sheet 11.5")),
    /** Which analog port the SIP shows. */
    ADSEL(35, Argument.number(0, 255, "port")),
    /** Value for GRIPPER 16 and 17. */
    GRIPPERVAL(36, Argument.signed("20 ms")),
    /** Gripper packets. */
    GRIPREQUEST(37, Argument.request()),
    /** Correction of the gyro clockwise. */
    GYROCALCW(38, Argument.size("")),
    /** Correction of the gyro counterclockwise. */
    GYROCALCCW(39, Argument.size("")),
    /** IO packets. */
    IOREQUEST(40, Argument.request()),
    /** Bytes to serial port AUX1. */
    TTY2(42, Argument.text(192, "bytes")),
    /** Reads serial port AUX1. */
    GETAUX(43, Argument.number(0, 200, "bytes, 0 flush")),
    /** Which bumpers stall the robot. */
    BUMPSTALL(44, Argument.number(0, 3, "0 none, 1 front, 2 rear, 3 both")),
    /** Commands for the tilting compass. */
    TCM2(45, Argument.size("")),
    /** Whether the plugged-in joystick drives during a session. */
    JOYDRIVE(47, Argument.onOff()),
    /** Sonar firing period. */
    SONARCYCLE(48, Argument.size("ms")),
    /** Whether a lamp blinks as the robot moves. */
    MOVINGBLINK(49, Argument.onOff()),
    /** Speed of the port to the client. */
    HOSTBAUD(50, Argument.number(0, 4, "0 9600, 1 19200, 2 38400, 3 57600, 4 115200 baud")),
    /** Speed of serial port AUX1. */
    AUX1BAUD(51, Argument.number(0, 4, "as HOSTBAUD")),
    /** Speed of serial port AUX2. */
    AUX2BAUD(52, Argument.number(0, 4, "as HOSTBAUD")),
    /** Speed of serial port AUX3. */
    AUX3BAUD(53, Argument.number(0, 4, "as HOSTBAUD")),
    /** Stops as hard as possible. */
    ESTOP(55, Argument.none()),
    /** Whether the STOP button stalls and disables the motors. */
    E_STALL(56, Argument.onOff()),
    /** Quick stop. */
    QSTOP(57, Argument.none()),
    /** Gyro packets. */
    GYRO(58, Argument.onOff()),
    /** Bytes to serial port AUX3. */
    TTY4(60, Argument.text(192, "bytes")),
    /** Reads serial port AUX3. */
    GETAUX3(61, Argument.number(0, 200, "bytes, 0 flush")),
    /** Battery packets. */
    BATTERYINFO(62, Argument.request()),
    /** Calibrates the compass. */
    CALCOMP(65, Argument.size("")),
    /** Bytes to serial port AUX2. */
    TTY3(66, Argument.text(192, "bytes")),
    /** Reads serial port AUX2. */
    GETAUX2(67, Argument.number(0, 200, "bytes, 0 flush")),
    /** Docking mechanism. */
    CHARGE(68, Argument.number(0, 1, "0 release, 1 deploy")),
    /** Proportional gain of turning. */
    ROTKP(82, Argument.size("")),
    /** Derivative gain of turning. */
    ROTKV(83, Argument.size("")),
    /** Integral gain of turning. */
    ROTKI(84, Argument.size("")),
    /** Proportional gain of driving. */
    TRANSKP(85, Argument.size("")),
    /** Derivative gain of driving. */
    TRANSKV(86, Argument.size("")),
    /** Integral gain of driving. */
    TRANSKI(87, Argument.size("")),
    /** Difference of the encoders over a full turn. */
    REVCOUNT(88, Argument.size("ticks")),
    /** By how much one wheel is larger. */
    DRIFTFACTOR(89, Argument.signed("")),
    /** Mutes the buzzer. */
    SOUNDTOG(92, Argument.number(0, 1, "0 mute, 1 sound")),
    /** Encoder ticks per mm. */
    TICKSMM(93, Argument.size("ticks")),
    /** A power switch; its load depends on the model. */
    POWER95(95, Argument.onOff()),
    /** A power switch. */
    POWER96(96, Argument.onOff()),
    /** A power switch. */
    POWER97(97, Argument.onOff()),
    /** A power switch. */
    POWER98(98, Argument.onOff()),
    /** Speed sideways, for robots that can. */
    LATVEL(110, Argument.signed("mm/s")),
    /** Acceleration sideways when positive, deceleration when negative. */
    LATACCEL(113, Argument.signed("mm/s²")),
    /** Packets of the accelerometer. */
    ACCELINFO(123, Argument.request()),
    /** Packets of the motors' torque. */
    TORQUEINFO(124, Argument.request()),
    /** A power switch. */
    POWER125(125, Argument.onOff()),
    /** A power switch. */
    POWER126(126, Argument.onOff()),
    /** A power switch. */
    POWER127(127, Argument.onOff()),
    /** A power switch. */
    POWER128(128, Argument.onOff()),
    /** A power switch. */
    POWER129(129, Argument.onOff()),
    /** Packets of the heading. */
    HEADINGINFO(149, Argument.request()),
    /** Whether the turn rate is controlled by the gyro. */
    ROTVEL_CLOSEDLOOP_ENABLE(150, Argument.onOff()),
    /** Scans of the laser of a simulator. */
    SIM_LRF_ENABLE(230, Argument.number(0, 2, "0 off, 1 packets 0x60, 2 packets 0x61")),
    /** Where its field begins, from straight ahead. */
    SIM_LRF_SET_FOV_START(231, Argument.number(-180, 180, "deg")),
    /** Where its field ends. */
    SIM_LRF_SET_FOV_END(232, Argument.number(-180, 180, "deg")),
    /** From one of its readings to the next. */
    SIM_LRF_SET_RES(233, Argument.size("0.01 deg")),
    /** Simulates a battery voltage. */
    BATTEST(250, Argument.number(0, 255, "0.1 V, 0 the real one")),
    /** Restarts the controller. Ends the vendor's simulator. */
    RESET(253, Argument.none()),
    /** Puts the controller into its maintenance mode. Ends the vendor's simulator. */
    MAINTENANCE(255, Argument.none());

    private final int number;
    private final Argument argument;

    ArcosCommand(int number, Argument argument) {
        this.number = number;
        this.argument = argument;
    }

    /** Encodings of arguments. */
    public enum Kind {
        /** Nothing follows. */
        NONE,
        /** A number of 16 bits and its sign. */
        INT,
        /** Two bytes in place of a number. */
        TWO_BYTES,
        /** A length and as many bytes. */
        STRING
    }

    /**
     * The argument of a command (ARCOS sheet 3, 6). Immutable.
     *
     * @param kind its encoding
     * @param least the smallest number, or the smallest of each of two bytes
     * @param most the largest number, the largest of each of two bytes, or the longest string in bytes
     * @param unit its unit or meaning; empty if there is none
     */
    public record Argument(Kind kind, int least, int most, String unit) {
        /** Every firmware accepts signed 16-bit numbers, not all accept more. */
        private static final int WIDEST = 0x7FFF;

        static Argument none() {
            return new Argument(Kind.NONE, 0, 0, "");
        }

        static Argument number(int least, int most, String unit) {
            return new Argument(Kind.INT, least, most, unit);
        }

        static Argument size(String unit) {
            return number(0, WIDEST, unit);
        }

        static Argument signed(String unit) {
            return number(-WIDEST, WIDEST, unit);
        }

        static Argument onOff() {
            return number(0, 1, "0 off, 1 on");
        }

        static Argument request() {
            return number(0, 2, "0 stop, 1 once, 2 with every SIP");
        }

        static Argument twoBytes(int least, int most, String unit) {
            return new Argument(Kind.TWO_BYTES, least, most, unit);
        }

        static Argument text(int longest, String unit) {
            return new Argument(Kind.STRING, 0, longest, unit);
        }

        private String range() {
            String counted = unit.isEmpty() ? "" : " (" + unit + ")";
            return kind == Kind.STRING ? "at most " + most + " bytes" : least + " to " + most + counted;
        }
    }

    /**
     * The command with a number.
     *
     * @throws IllegalArgumentException if there is none
     */
    public static ArcosCommand of(int number) {
        return Arrays.stream(values())
                .filter(command -> command.number == number)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("there is no command " + number));
    }

    /** Its number, the type of its packet. */
    public int number() {
        return number;
    }

    /** The kind and range of its argument. */
    public Argument argument() {
        return argument;
    }

    /**
     * The packet without an argument.
     *
     * @throws IllegalArgumentException if the command takes one
     */
    public Packet packet() {
        check(Kind.NONE);
        return Packet.bare(number);
    }

    /**
     * The packet with a whole number; its sign travels in the type byte.
     *
     * @param value in the unit and range of {@link #argument()}
     * @throws IllegalArgumentException if the command takes no such argument, or the value is out of range
     */
    public Packet packet(int value) {
        check(Kind.INT, value);
        return Packet.ofNumber(number, value);
    }

    /**
     * The packet with two bytes.
     *
     * @param low the first on the wire
     * @param high the second
     * @throws IllegalArgumentException if the command takes no such argument, or the value is out of range
     */
    public Packet packet(int low, int high) {
        check(Kind.TWO_BYTES, low, high);
        return Packet.ofTwoBytes(number, low, high);
    }

    /**
     * The packet with a length and that many bytes.
     *
     * @throws IllegalArgumentException if the command takes no bytes, or fewer
     */
    public Packet packet(byte[] text) {
        check(Kind.STRING, text.length);
        return Packet.ofString(number, text);
    }

    private void check(Kind given, int... values) {
        if (given != argument.kind) {
            throw new IllegalArgumentException(this + " takes " + argument.kind + ", not " + given);
        }
        for (int value : values) {
            if (value < argument.least || value > argument.most) {
                throw new IllegalArgumentException(this + " takes " + argument.range() + ", not " + value);
            }
        }
    }
}
