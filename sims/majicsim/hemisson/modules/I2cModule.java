package majicsim.hemisson.modules;

/** An extension module on the I²C bus (sheet 9). */
interface I2cModule {
    ModuleKind kind();

    /** One byte of a read that began at a register. */
    int read(int register, int index);

    /** Bytes of one write that began at a register; at least one. */
    void write(int register, int[] bytes);

    default void step(double seconds) {}

    /** Whether only time passes on it. */
    default boolean isIdle() {
        return true;
    }
}
