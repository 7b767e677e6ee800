package majicsim.aibo.sound;

import java.nio.charset.StandardCharsets;
import majicsim.aibo.body.Gait;
import majicsim.aibo.urbi.Kernel;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.value.Value;
import majicsim.world.Noise;

/**
 * The two microphones: always the last 32 ms (URBI sheet, section 13). They record the dog's own speaker and motors, a
 * whistle beside it, and in a lab with noise a quiet hiss.
 */
public final class Microphone {
    private static final int FRAMES = 512;
    private static final double PER_MS = Sound.RATE_HZ / 1000.0;
    private static final double OWN_SPEAKER = 0.5;
    private static final double HUM_HZ = 190;
    private static final double HUM = 900;
    private static final double STEPS_HZ = 2;
    private static final double WHISTLE = 8000;
    private static final double HISS = 25;

    private final Kernel kernel;
    private final Speaker speaker;
    private final Gait gait;
    private final Noise noise;
    private double whistleHz;
    private double whistleEndMs;

    public Microphone(Kernel kernel, Speaker speaker, Gait gait, Noise noise) {
        this.kernel = kernel;
        this.speaker = speaker;
        this.gait = gait;
        this.noise = noise;
    }

    public void install() {
        kernel.memory().variables().put(new Variable("micro.val", Value.VOID, this::recorded));
    }

    /** Starts a whistle beside the dog. */
    public void whistle(double hertz, double ms) {
        whistleHz = hertz;
        whistleEndMs = kernel.nowMs() + ms;
    }

    /** The kernel repeats the last parameter of binaries that it makes itself (sheet, section 12). */
    private Value recorded() {
        long end = Math.round(kernel.nowMs() * PER_MS);
        byte[] bytes = new byte[4 * FRAMES];
        for (int i = 0; i < FRAMES; i++) {
            double sound = sound(end - FRAMES + i);
            put(bytes, 4 * i, sound);
            put(bytes, 4 * i + 2, sound);
        }
        return new Value.Binary(new String(bytes, StandardCharsets.ISO_8859_1), "raw 2 16000 16 1 1");
    }

    private double sound(long index) {
        double seconds = index / (double) Sound.RATE_HZ;
        double sum = OWN_SPEAKER * speaker.sample(index);
        if (gait.isWalking()) {
            double step = Math.abs(Math.sin(Math.PI * STEPS_HZ * seconds));
            sum += HUM * (0.3 + step) * Math.sin(2 * Math.PI * HUM_HZ * seconds);
        }
        if (seconds * 1000 < whistleEndMs) {
            sum += WHISTLE * Math.sin(2 * Math.PI * whistleHz * seconds);
        }
        return sum;
    }

    private void put(byte[] bytes, int at, double sound) {
        double hiss = noise.isExact() ? 0 : noise.uniform(-HISS, HISS);
        int value = (int) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, Math.rint(sound + hiss)));
        bytes[at] = (byte) value;
        bytes[at + 1] = (byte) (value >> 8);
    }
}
