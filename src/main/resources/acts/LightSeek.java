import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import majic.act.Argument;
import majic.act.MajicAct;
import majic.act.Role;

/**
 * A robot drives to a lamp: every sensor that detects light turns it to that sensor's direction. Without light it
 * wanders.
 */
public final class LightSeek extends MajicAct {
    private static final long serialVersionUID = 1;

    /** The directions of the sensors light0 to light5. */
    private static final double[] LOOKS_DEG = {0, -45, 45, -90, 90, 180};

    private static final double PULL_OF_A_LAMP = 12;
    private static final double STRIDE_MM = 120;
    private static final int LOOKS = 4;

    @Argument(value = "the reading at which it has arrived, 0 bright to 255 dark", from = 0, to = 255)
    private double bright = 40;

    @Override
    public List<Role> roles() {
        Stream<String> sensors = IntStream.range(0, LOOKS_DEG.length).mapToObj(sensor -> "light" + sensor);
        String[] wanted =
                Stream.concat(sensors, Stream.of("distanceFront", "near")).toArray(String[]::new);
        return List.of(Role.any(Role.ME).with(wanted));
    }

    @Override
    protected void behave() {
        double[] light = look();
        while (brightest(light) > bright) {
            double pull = pull(light);
            if (!Double.isNaN(pull)) {
                bot.turn(pull);
            }
            bot.move(STRIDE_MM, this::isSomethingNear);
            if (isSomethingNear()) {
                bot.turn(100);
            }
            light = look();
        }
        say("here is the light");
    }

    /** Returns the sensors' readings, 0 bright to 255 dark; the mean of several readings, since one alone is noisy. */
    private double[] look() {
        double[] light = new double[LOOKS_DEG.length];
        for (int look = 0; look < LOOKS; look++) {
            for (int sensor = 0; sensor < light.length; sensor++) {
                light[sensor] += bot.get("light" + sensor).number() / LOOKS;
            }
            pause(0.05);
        }
        return light;
    }

    /** Returns the direction of the light, degrees; not a number if there is none. */
    private static double pull(double[] light) {
        double dark = 0;
        for (double one : light) {
            dark = Math.max(dark, one);
        }
        double ahead = 0;
        double left = 0;
        for (int sensor = 0; sensor < light.length; sensor++) {
            ahead += (dark - light[sensor]) * Math.cos(Math.toRadians(LOOKS_DEG[sensor]));
            left += (dark - light[sensor]) * Math.sin(Math.toRadians(LOOKS_DEG[sensor]));
        }
        return Math.hypot(ahead, left) < PULL_OF_A_LAMP ? Double.NaN : Math.toDegrees(Math.atan2(left, ahead));
    }

    private static double brightest(double[] light) {
        double brightest = light[0];
        for (double one : light) {
            brightest = Math.min(brightest, one);
        }
        return brightest;
    }

    private boolean isSomethingNear() {
        return bot.get("distanceFront").number() < bot.get("near").number();
    }
}
