package majicsim.hemisson.modules;

/**
 * General input and output HemGenIO: five analogue inputs, twelve digital lines that are inputs until they are written.
 */
public final class GeneralIo implements I2cModule {
    static final int ANALOGUE = 0x10;
    public static final int ANALOGUES = 5;

    private static final int DIGITAL = 0x20;
    private static final int DIGITALS_IN_ROW = 10;
    private static final int DIGITAL_ROW_TWO = 0x30;
    public static final int DIGITALS = 12;

    private final Registers registers = new Registers();

    GeneralIo() {
        registers.set(0, 1);
    }

    @Override
    public ModuleKind kind() {
        return ModuleKind.IO;
    }

    @Override
    public int read(int register, int index) {
        return registers.at(register + index);
    }

    @Override
    public void write(int register, int[] bytes) {
        for (int i = 0; i < bytes.length; i++) {
            if (isDigital(register + i)) {
                registers.set(register + i, bytes[i] == 0 ? 0 : 1);
            }
        }
    }

    /** Sets the voltage at an analogue input, 0 to 255. */
    public void analogue(int channel, int value) {
        registers.set(ANALOGUE + channel, value);
    }

    /** Sets the level of a digital line from outside. */
    public void digital(int line, boolean high) {
        registers.set(registerOf(line), high ? 1 : 0);
    }

    public boolean isHigh(int line) {
        return registers.at(registerOf(line)) != 0;
    }

    private static int registerOf(int line) {
        return line < DIGITALS_IN_ROW ? DIGITAL + line : DIGITAL_ROW_TWO + line - DIGITALS_IN_ROW;
    }

    private static boolean isDigital(int register) {
        int line = register - DIGITAL;
        return line >= 0 && line < DIGITALS_IN_ROW
                || register >= DIGITAL_ROW_TWO && register < DIGITAL_ROW_TWO + DIGITALS - DIGITALS_IN_ROW;
    }
}
