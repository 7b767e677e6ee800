package majicsim.hemisson.board;

import java.util.Arrays;

/**
 * The firmware's 80-byte command buffer (sheet 4.2). It is not cleared between commands, so a missing argument is
 * whatever an earlier command left there, and in K-Team's firmware its pointer sticks for good when it reaches the end.
 * The sensor tables lie in the same memory, from the 51st character on: a longer command shows in them, and they may
 * spoil it.
 */
public final class CommandBuffer {
    public static final int SIZE = 80;
    static final char END = '\r';

    /** Where the sensor tables begin. */
    static final int TABLES = 50;

    private final char[] memory = new char[SIZE];
    private final boolean kTeam;
    private int fill;
    private char last;
    private int length;
    private boolean overflowed;

    /**
     * Creates an empty buffer.
     *
     * @param kTeam whether its pointer sticks when it is full and lower-case hex digits are misread, as in K-Team's
     *     firmware; otherwise only that command is lost, and both cases are read
     */
    public CommandBuffer(boolean kTeam) {
        this.kTeam = kTeam;
    }

    /** Takes one character. */
    public void put(char c) {
        last = c;
        if (fill < SIZE) {
            memory[fill++] = c;
        }
    }

    /** Whether the last character ends a command; if so, the next one begins another. */
    public boolean takeCommand() {
        if (last != END || isStuck()) {
            return false;
        }
        overflowed = fill == SIZE;
        length = fill - 1;
        fill = 0;
        return true;
    }

    public boolean isStuck() {
        return kTeam && fill == SIZE;
    }

    /** Whether the command that has ended was too long to fit; never in a buffer that sticks. */
    public boolean hasOverflowed() {
        return overflowed;
    }

    /** The command that has ended, without its end. */
    public String text() {
        return new String(memory, 0, length);
    }

    /** A piece of the memory. */
    String text(int from, int count) {
        return new String(memory, from, count);
    }

    public char at(int position) {
        return memory[position];
    }

    /** The memory is written by another part of the firmware. */
    void poke(int position, int value) {
        memory[position] = (char) (value & 0xFF);
    }

    /** The character minus 48, whatever it is, as a signed byte. */
    public int digit(int position) {
        return (byte) (memory[position] - '0');
    }

    /** Two hex digits; K-Team's firmware misreads a lower-case letter in the low place: 0a is 2A. */
    public int hex(int position) {
        return (nibble(position) * 16 + nibble(position + 1)) & 0xFF;
    }

    public boolean isOn(int position) {
        return memory[position] != '0';
    }

    public void clear() {
        Arrays.fill(memory, '\0');
        fill = 0;
    }

    private int nibble(int position) {
        char c = kTeam ? memory[position] : Character.toUpperCase(memory[position]);
        return c > '9' ? c - 'A' + 10 : c - '0';
    }
}
