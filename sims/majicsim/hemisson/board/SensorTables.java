package majicsim.hemisson.board;

/**
 * The firmware's two sensor tables, which lie in the command buffer's memory and are refreshed every 41 ms (sheet 4.2,
 * 4.6, 6). Proximity is ambient minus lit, modulo 256, never above the ambient value; ground left subtracts from the
 * ambient value of ground right, a slip of the real firmware.
 */
public final class SensorTables {
    private static final double ROUND_SECONDS = 0.041;
    private static final int GROUND_RIGHT = 6;
    private static final int GROUND_LEFT = 7;
    private static final double HAIR = 1e-9;

    /** Where each sensor lies in its table, in the order of commands N and O; read in the factory image. */
    private static final int[] PLACES = {2, 0, 1, 5, 4, 3, 7, 6};

    private static final int AMBIENT = CommandBuffer.TABLES;
    private static final int PROXIMITY = AMBIENT + InfraRedSensors.COUNT;

    private final InfraRedSensors sensors;
    private final CommandBuffer memory;
    private final int[] ambient = new int[InfraRedSensors.COUNT];
    private final int[] response = new int[InfraRedSensors.COUNT];
    private double sinceSeconds;
    private boolean fresh;

    public SensorTables(InfraRedSensors sensors, CommandBuffer memory) {
        this.sensors = sensors;
        this.memory = memory;
        refresh();
    }

    /** The time until the round ends. */
    public double restSeconds() {
        return ROUND_SECONDS - HAIR - sinceSeconds;
    }

    /** True when a round has just ended. */
    public boolean step(double seconds) {
        sinceSeconds += seconds;
        if (sinceSeconds < ROUND_SECONDS - HAIR) {
            return false;
        }
        sinceSeconds -= ROUND_SECONDS;
        refresh();
        return true;
    }

    public int proximity(int sensor) {
        return memory.at(PROXIMITY + PLACES[sensor]);
    }

    public int ambient(int sensor) {
        return memory.at(AMBIENT + PLACES[sensor]);
    }

    /** Both tables as they lie in the memory: proximity, then ambient. */
    public String tables() {
        return memory.text(PROXIMITY, InfraRedSensors.COUNT) + memory.text(AMBIENT, InfraRedSensors.COUNT);
    }

    /** Whether the tables were refreshed since the last call. */
    public boolean takeFresh() {
        boolean was = fresh;
        fresh = false;
        return was;
    }

    /** Starts a new round: reads all sensors. */
    public void refresh() {
        sensors.look(ambient, response);
        for (int i = 0; i < InfraRedSensors.COUNT; i++) {
            int lit = Math.max(0, ambient[i] - response[i]);
            int minuend = i == GROUND_LEFT ? ambient[GROUND_RIGHT] : ambient[i];
            memory.poke(PROXIMITY + PLACES[i], minuend - lit);
            memory.poke(AMBIENT + PLACES[i], ambient[i]);
        }
        fresh = true;
    }
}
