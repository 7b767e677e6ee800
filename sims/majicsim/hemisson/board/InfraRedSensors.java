package majicsim.hemisson.board;

/** The raw readings of the eight infra-red sensors, in the order of command N (sheet 6). */
public interface InfraRedSensors {
    /** Number of sensors. */
    int COUNT = 8;

    /** Reads all sensors; writes 8-bit readings: ambient light (255 dark), and how much the emitter lowers it. */
    void look(int[] ambient, int[] response);
}
