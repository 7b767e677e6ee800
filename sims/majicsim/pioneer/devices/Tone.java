package majicsim.pioneer.devices;

/**
 * One note of the buzzer. Immutable.
 *
 * @param hertz its pitch; 0 is a rest
 * @param durationMs how long it lasts, in steps of 20 ms
 */
public record Tone(double hertz, int durationMs) {
    private static final int MS_PER_UNIT = 20;
    private static final int HIGHEST_MIDI_NOTE = 127;
    private static final int HERTZ_PER_UNIT = 32;

    /** From the two bytes that SAY has for it: 1 to 127 are MIDI notes, above that 32 Hz a step (ARCOS sheet 6.1). */
    static Tone of(int duration, int tone) {
        return new Tone(hertz(tone), duration * MS_PER_UNIT);
    }

    private static double hertz(int tone) {
        if (tone == 0) {
            return 0;
        }
        return tone <= HIGHEST_MIDI_NOTE
                ? 440 * Math.pow(2, (tone - 69) / 12.0)
                : (double) (tone - HIGHEST_MIDI_NOTE) * HERTZ_PER_UNIT;
    }
}
