package majicsim.hemisson.modules;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.World;

/**
 * The ultrasonic sensor HemUltraSonicSensor, an SRF08: a command in register 00 starts a measurement, 65 ms later up to
 * 17 echoes are at register 02.
 */
public final class Ultrasonic implements I2cModule {
    public static final int COMMAND = 0x00;
    public static final int LIGHT = 0x01;
    public static final int FIRST_ECHO = 0x02;
    public static final int RANGE = 0x02;
    public static final int INCHES = 0x50;
    public static final int CENTIMETRES = 0x51;
    public static final int MICROSECONDS = 0x52;
    public static final int ECHOES = 17;
    public static final double PING_SECONDS = 0.065;
    public static final int RANGE_STEP_MM = 43;

    private static final int FARTHEST_MM = 6000;
    private static final int NEAREST_MM = 30;
    private static final double[] BEAM_DEG = {-24, -12, 0, 12, 24};
    private static final int VERSION = 6;

    private final World world;
    private final Body body;
    private final Registers registers = new Registers();
    private int command;
    private int range = 0xFF;
    private double leftSeconds;

    Ultrasonic(World world, Body body) {
        this.world = world;
        this.body = body;
    }

    @Override
    public ModuleKind kind() {
        return ModuleKind.ULTRASONIC;
    }

    /** While it waits for echoes it does not answer at its address. */
    @Override
    public int read(int register, int index) {
        if (leftSeconds > 0) {
            return 0xFF;
        }
        int at = (register + index) & 0xFF;
        return at == COMMAND ? VERSION : registers.at(at);
    }

    @Override
    public void write(int register, int[] bytes) {
        int value = bytes[0];
        if (register == RANGE) {
            range = value;
        } else if (register == COMMAND && value >= INCHES && value <= MICROSECONDS) {
            command = value;
            leftSeconds = PING_SECONDS;
        }
    }

    @Override
    public boolean isIdle() {
        return leftSeconds <= 0;
    }

    @Override
    public void step(double seconds) {
        if (leftSeconds > 0) {
            leftSeconds -= seconds;
            if (leftSeconds <= 0) {
                detectEchoes();
            }
        }
    }

    private void detectEchoes() {
        double light = world.ambientLight(body.pose().xMm(), body.pose().yMm());
        registers.set(LIGHT, (int) Math.round(255 * Math.min(1, light)));
        List<Integer> echoes = Arrays.stream(BEAM_DEG)
                .mapToObj(this::cast)
                .filter(Hit::found)
                .map(hit -> inUnit(Math.max(NEAREST_MM, hit.distanceMm())))
                .collect(Collectors.toSet())
                .stream()
                .sorted()
                .toList();
        for (int i = 0; i < ECHOES; i++) {
            registers.setWord(FIRST_ECHO + 2 * i, i < echoes.size() ? echoes.get(i) : 0);
        }
    }

    private Hit cast(double aside) {
        int reachMm = Math.min(FARTHEST_MM, range * RANGE_STEP_MM + RANGE_STEP_MM);
        return world.ray(body, body.pose().xMm(), body.pose().yMm(), body.pose().toWorldDeg(aside), reachMm);
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
