package majicsim.hemisson.board;

/** What the eight infra-red sensors see, before the firmware computes with it; in the order of command N (sheet 6). */
public interface Eyes {
    /** Number of sensors. */
    int COUNT = 8;

    /** Reads all sensors; writes 8-bit readings: ambient light (255 dark), and how much the emitter lowers it. */
    void look(int[] ambient, int[] response);
}
