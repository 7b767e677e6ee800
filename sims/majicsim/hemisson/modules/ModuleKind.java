package majicsim.hemisson.modules;

/** An extension module that may sit on the I²C bus (sheet 9). */
public enum ModuleKind {
    /** The linear camera HemLinCam at C0. */
    CAMERA(0xC0, 'L', 1),
    /** The ultrasonic sensor HemUltraSonicSensor at E0. */
    ULTRASONIC(0xE0, 'U', 0),
    /** Text to speech at C4. */
    SPEECH(0xC4, 'T', 5),
    /** The display HemLcd at A0. */
    LCD(0xA0, 'D', 4),
    /** General input and output HemGenIO at D0. */
    IO(0xD0, 'G', 0);

    private final int address;
    private final char letter;
    private final double wakeSeconds;

    ModuleKind(int address, char letter, double wakeSeconds) {
        this.address = address;
        this.letter = letter;
        this.wakeSeconds = wakeSeconds;
    }

    /** Its write address, even, 02 to FC. */
    public int address() {
        return address;
    }

    /** Its name in the RoadNarrows dialect (sheet 10). */
    public char letter() {
        return letter;
    }

    /** How long after power-up it does not answer yet. */
    double wakeSeconds() {
        return wakeSeconds;
    }
}
