package majicsim.hemisson;

import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.World;

/** The ultrasonic sensor HemUltraSonicSensor, an SRF08: a command in register 00 pings, 65 ms later the echoes stand at 02. */
final class Ultrasonic implements I2cModule {
    private static final int COMMAND = 0x00;
    private static final int FIRST_ECHO = 0x02;
    private static final int INCHES = 0x50;
    private static final int CENTIMETRES = 0x51;
    private static final int MICROSECONDS = 0x52;
    private static final double PING_SECONDS = 0.065;
    private static final double FARTHEST_MM = 6000;
    private static final double NEAREST_MM = 30;
    private static final double[] BEAM_DEG = {-24, -12, 0, 12, 24};
    private static final int VERSION = 6;

    private final World world;
    private final Body body;
    private final int[] registers = new int[256];
    private int command;
    private double leftSeconds;

    Ultrasonic(World world, Body body) {
        this.world = world;
        this.body = body;
    }

    @Override
    public int address() {
        return 0xE0;
    }

    @Override
    public int read(int register, int index) {
        if (leftSeconds > 0) {
            return 0xFF;
        }
        int at = (register + index) & 0xFF;
        return at == COMMAND ? VERSION : registers[at];
    }

    @Override
    public void write(int register, int value) {
        if (register == COMMAND && value >= INCHES && value <= MICROSECONDS) {
            command = value;
            leftSeconds = PING_SECONDS;
        }
    }

    @Override
    public void step(double seconds) {
        if (leftSeconds > 0) {
            leftSeconds -= seconds;
            if (leftSeconds <= 0) {
                hear();
            }
        }
    }

    private void hear() {
        double nearest = FARTHEST_MM;
        for (double aside : BEAM_DEG) {
            Hit hit = world.ray(
                    body, body.pose().xMm(), body.pose().yMm(), body.pose().toWorldDeg(aside), FARTHEST_MM);
            nearest = Math.min(nearest, hit.distanceMm());
        }
        int value = nearest >= FARTHEST_MM ? 0 : inUnit(Math.max(NEAREST_MM, nearest));
        registers[FIRST_ECHO] = value >> 8;
        registers[FIRST_ECHO + 1] = value & 0xFF;
    }

    private int inUnit(double mm) {
        return (int) Math.round(
                switch (command) {
                    case INCHES -> mm / 25.4;
                    case CENTIMETRES -> mm / 10;
                    default -> 2 * mm / 0.343;
                });
    }
}
