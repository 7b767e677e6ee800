package majic.gui;

import java.awt.Toolkit;
import java.util.Optional;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.SourceDataLine;
import majic.environment.Settings;
import majic.gui.kit.BackgroundSettings;
import majic.log.Line;
import majic.log.SessionListener;

/**
 * Plays a short sound for a lost connection and for a stop that was not confirmed, unless that is switched off, which
 * is kept. At most one a second. Thread-safe.
 */
final class AlarmSound implements SessionListener {
    private static final String KEY = "window.alarmSound";
    private static final String OFF = "off";
    private static final long PAUSE_NANOS = 1_000_000_000L;

    private final Settings settings;
    private final Runnable player;
    private volatile boolean on;
    private long nextNanos = System.nanoTime();

    /**
     * Creates the sound as it was switched last.
     *
     * @param player plays it; may block
     */
    AlarmSound(Settings settings, Runnable player) {
        this.settings = settings;
        this.player = player;
        on = !settings.get(KEY).equals(Optional.of(OFF));
    }

    boolean isOn() {
        return on;
    }

    /** Switches the sound on or off, and keeps the choice. */
    void switchOn(boolean wanted) {
        on = wanted;
        BackgroundSettings.put(settings, KEY, wanted ? "on" : OFF);
    }

    /** Called on a thread of its own, which the sound may block. */
    @Override
    public void line(Line line) {
        if (on && line.kind() == Line.Kind.ALARM && System.nanoTime() - nextNanos >= 0) {
            player.run();
            nextNanos = System.nanoTime() + PAUSE_NANOS;
        }
    }

    /** Plays the sound; may block. */
    static void play() {
        Tones.play();
    }

    /** Plays two tones; a class of its own, so that the start of the program loads nothing of it. */
    private static final class Tones {
        private static final int RATE = 16_000;
        private static final int LENGTH = RATE * 15 / 100;
        private static final int FADE = RATE / 100;
        private static final int[] FREQUENCIES = {880, 660};
        private static final int LOUDNESS = 70;

        private Tones() {}

        /** Plays the sound of the desktop if there is no loudspeaker. */
        static void play() {
            AudioFormat format = new AudioFormat(RATE, 8, 1, true, false);
            try (SourceDataLine speaker = AudioSystem.getSourceDataLine(format)) {
                byte[] tones = alarm();
                speaker.open(format);
                speaker.start();
                speaker.write(tones, 0, tones.length);
                speaker.drain();
            } catch (LineUnavailableException | IllegalArgumentException e) {
                Toolkit.getDefaultToolkit().beep();
            }
        }

        private static byte[] alarm() {
            byte[] samples = new byte[FREQUENCIES.length * LENGTH];
            for (int index = 0; index < samples.length; index++) {
                int inTone = index % LENGTH;
                double turns = (double) inTone * FREQUENCIES[index / LENGTH] / RATE;
                double edge = Math.min(1, Math.min(inTone, LENGTH - inTone) / (double) FADE);
                samples[index] = (byte) (LOUDNESS * edge * Math.sin(2 * Math.PI * turns));
            }
            return samples;
        }
    }
}
