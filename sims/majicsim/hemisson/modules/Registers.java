package majicsim.hemisson.modules;

/** The 256 registers of a module. */
final class Registers {
    private final int[] values = new int[256];

    int at(int register) {
        return values[register & 0xFF];
    }

    void set(int register, int value) {
        values[register & 0xFF] = value & 0xFF;
    }

    /** Bytes go into one register after the other. */
    void store(int register, int[] bytes) {
        for (int i = 0; i < bytes.length; i++) {
            set(register + i, bytes[i]);
        }
    }

    /** A value of two bytes, high one first. */
    void setWord(int register, int value) {
        set(register, value >> 8);
        set(register + 1, value);
    }
}
