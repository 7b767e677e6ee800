package majicsim.hemisson.modules;

import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.World;

/**
 * The linear camera HemLinCam: 102 pixels from left to right, brighter the nearer and paler the wall and the longer the
 * exposure.
 */
public final class LinearCamera implements I2cModule {
    public static final int VERSION_REGISTER = 0x00;
    public static final int PIXELS = 0x10;
    public static final int THRESHOLDED = 0x11;
    public static final int THRESHOLD = 0x20;
    public static final int EXPOSURE = 0x21;
    public static final int LED = 0x30;
    public static final int PIXEL_COUNT = 102;

    private static final int VERSION = 1;
    private static final int POWER_UP_THRESHOLD = 128;
    private static final double VIEW_DEG = 36;
    private static final double FARTHEST_MM = 3000;

    /** A white wall close by, seen for 1 ms. */
    private static final double BRIGHTEST = 230;

    private final World world;
    private final Body body;
    private final Registers registers = new Registers();

    LinearCamera(World world, Body body) {
        this.world = world;
        this.body = body;
        registers.set(VERSION_REGISTER, VERSION);
        registers.set(THRESHOLD, POWER_UP_THRESHOLD);
        registers.set(EXPOSURE, 1);
    }

    @Override
    public ModuleKind kind() {
        return ModuleKind.CAMERA;
    }

    @Override
    public int read(int register, int index) {
        return switch (register) {
            case PIXELS -> index < PIXEL_COUNT ? pixel(index) : 0;
            case THRESHOLDED -> index < PIXEL_COUNT && pixel(index) > registers.at(THRESHOLD) ? 255 : 0;
            default -> registers.at(register + index);
        };
    }

    @Override
    public void write(int register, int[] bytes) {
        registers.store(register, bytes);
        registers.set(VERSION_REGISTER, VERSION);
    }

    private int pixel(int index) {
        double direction = VIEW_DEG / 2 - VIEW_DEG * index / (PIXEL_COUNT - 1);
        Hit hit = world.ray(
                body, body.pose().xMm(), body.pose().yMm(), body.pose().toWorldDeg(direction), FARTHEST_MM);
        double light = BRIGHTEST * hit.reflectivity() * (1 - hit.distanceMm() / FARTHEST_MM);
        return (int) Math.min(255, light * registers.at(EXPOSURE));
    }
}
