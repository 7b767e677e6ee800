package majicsim.hemisson;

import java.util.Arrays;

/**
 * The firmware's 80-byte command buffer (sheet 4.2). It is not cleared between commands, so a missing argument is whatever an earlier
 * command left there, and its pointer sticks for good when it reaches the end.
 */
final class CommandBuffer {
    static final int SIZE = 80;
    static final char END = '\r';

    private final char[] memory = new char[SIZE];
    private int fill;

    /** Takes one character; true when it ends a command that fits. */
    boolean put(char c) {
        if (isStuck()) {
            return false;
        }
        memory[fill++] = c;
        if (c != END || isStuck()) {
            return false;
        }
        fill = 0;
        return true;
    }

    boolean isStuck() {
        return fill == SIZE;
    }

    /** Where the next character goes. */
    int position() {
        return fill;
    }

    char at(int position) {
        return memory[position];
    }

    /** The character minus 48, whatever it is, as a signed byte. */
    int digit(int position) {
        return (byte) (memory[position] - '0');
    }

    /** Two hex digits; a lower-case letter in the low place is misread as the firmware does: 0a is 2A. */
    int hex(int position) {
        return (nibble(position) * 16 + nibble(position + 1)) & 0xFF;
    }

    boolean isOn(int position) {
        return memory[position] != '0';
    }

    void clear() {
        Arrays.fill(memory, '\0');
        fill = 0;
    }

    private int nibble(int position) {
        char c = memory[position];
        return c > '9' ? c - 'A' + 10 : c - '0';
    }
}
