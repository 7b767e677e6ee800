package majicsim.hemisson;

/** An extension module on the I²C bus (sheet 9). */
interface I2cModule {
    /** Its write address, even, 02 to FC. */
    int address();

    /** One byte of a read that began at a register. */
    int read(int register, int index);

    void write(int register, int value);

    default void step(double seconds) {}
}
