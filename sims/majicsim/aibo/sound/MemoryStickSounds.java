package majicsim.aibo.sound;

import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import org.jspecify.annotations.Nullable;

/** The sound files of the original stick by name (URBI sheet, section 13); their sounds are invented. */
public final class MemoryStickSounds {
    private static final double FULL = 0.6;
    private static final Map<String, Sound> FILES = Map.of(
            "bark", bark(300, 420),
            "bark2", bark(450, 330),
            "beep", tune(120, 1000),
            "start", tune(150, 523, 659, 784),
            "client", tune(100, 784, 1047),
            "welcome", tune(180, 523, 659, 784, 1047),
            "battery", tune(200, 440, 330, 440, 330),
            "drum1", bark(200, 90),
            "test", tune(1000, 440),
            "tecno", tune(125, 110, 220, 110, 247, 110, 262, 110, 220));

    private MemoryStickSounds() {}

    /** The file of that name, with or without its ending. */
    public static @Nullable Sound named(String file) {
        return FILES.get(file.replaceFirst("\\.wav$", ""));
    }

    private static Sound tune(double noteMs, double... hertz) {
        return Sound.of(noteMs * hertz.length, seconds -> {
            int note = Math.min(hertz.length - 1, (int) (seconds * 1000 / noteMs));
            return FULL * Math.sin(2 * Math.PI * hertz[note] * seconds);
        });
    }

    /** A tone that fades while its pitch falls. */
    private static Sound bark(double lengthMs, double hertz) {
        DoubleUnaryOperator loud = seconds -> Math.exp(-6 * seconds * 1000 / lengthMs);
        return Sound.of(lengthMs, seconds -> {
            double phase = 2 * Math.PI * hertz * seconds * (1 - 0.3 * seconds * 1000 / lengthMs);
            return FULL * loud.applyAsDouble(seconds) * (Math.sin(phase) + 0.5 * Math.sin(2.5 * phase)) / 1.5;
        });
    }
}
