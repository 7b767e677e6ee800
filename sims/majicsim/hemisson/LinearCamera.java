package majicsim.hemisson;

import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.World;

/** The linear camera HemLinCam: 102 pixels from left to right, brighter the nearer and paler the wall. */
final class LinearCamera implements I2cModule {
    private static final int PIXELS = 0x10;
    private static final int THRESHOLDED = 0x11;
    private static final int THRESHOLD = 0x20;
    private static final int PIXEL_COUNT = 102;
    private static final double VIEW_DEG = 36;
    private static final double FARTHEST_MM = 3000;
    private static final double BRIGHTEST = 230;

    private final World world;
    private final Body body;
    private final int[] registers = new int[256];

    LinearCamera(World world, Body body) {
        this.world = world;
        this.body = body;
    }

    @Override
    public int address() {
        return 0xC0;
    }

    @Override
    public int read(int register, int index) {
        return switch (register) {
            case PIXELS -> index < PIXEL_COUNT ? pixel(index) : 0;
            case THRESHOLDED -> index < PIXEL_COUNT && pixel(index) > registers[THRESHOLD] ? 1 : 0;
            default -> registers[(register + index) & 0xFF];
        };
    }

    @Override
    public void write(int register, int value) {
        registers[register] = value;
    }

    private int pixel(int index) {
        double direction = VIEW_DEG / 2 - VIEW_DEG * index / (PIXEL_COUNT - 1);
        Hit hit = world.ray(
                body, body.pose().xMm(), body.pose().yMm(), body.pose().toWorldDeg(direction), FARTHEST_MM);
        return (int) Math.min(255, BRIGHTEST * hit.reflectivity() * (1 - hit.distanceMm() / FARTHEST_MM));
    }
}
