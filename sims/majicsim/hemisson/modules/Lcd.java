package majicsim.hemisson.modules;

import java.util.Arrays;
import java.util.List;

/** The display HemLcd: two lines of 16 characters, written by Y with its count in front, and three keys. */
public final class Lcd implements I2cModule {
    static final int KEYS = 0x10;

    private static final int VERSION = 1;
    private static final int WIDTH = 16;
    private static final int UPPER = 0x10;
    private static final int LOWER = 0x20;
    private static final int CLEAR_LINE = 1;
    private static final int CENTRE = 2;
    private static final int RIGHT = 3;
    private static final int CLEAR_ALL = 0x30;

    private final char[][] lines = new char[2][WIDTH];
    private final Registers registers = new Registers();
    private int keys;

    Lcd() {
        clear(0);
        clear(1);
    }

    @Override
    public ModuleKind kind() {
        return ModuleKind.LCD;
    }

    @Override
    public int read(int register, int index) {
        return switch (register + index) {
            case 0 -> VERSION;
            case KEYS -> keys;
            default -> registers.at(register + index);
        };
    }

    @Override
    public void write(int register, int[] bytes) {
        if (register == CLEAR_ALL) {
            clear(0);
            clear(1);
        } else if ((register & 0xF0) == UPPER || (register & 0xF0) == LOWER) {
            writeLine((register & 0xF0) == UPPER ? 0 : 1, register & 0x0F, bytes);
        } else {
            registers.store(register, bytes);
        }
    }

    /** Sets which of its keys are held: bits 0 to 2. */
    public void press(int newKeys) {
        keys = newKeys;
    }

    public List<String> shown() {
        return List.of(new String(lines[0]), new String(lines[1]));
    }

    private void writeLine(int line, int how, int[] bytes) {
        clear(line);
        if (how == CLEAR_LINE) {
            return;
        }
        int length = Math.min(Math.min(bytes[0], bytes.length - 1), WIDTH);
        int from = how == CENTRE ? (WIDTH - length) / 2 : how == RIGHT ? WIDTH - length : 0;
        for (int i = 0; i < length; i++) {
            lines[line][from + i] = (char) bytes[1 + i];
        }
    }

    private void clear(int line) {
        Arrays.fill(lines[line], ' ');
    }
}
