package majicsim.aibo.sound;

/**
 * A sound that the dog's speaker played, plays or has queued.
 *
 * @param what the file's name on the stick, or "sent" for a sound from a client
 * @param startMs its start, ms of lab time
 * @param sound all of it
 */
public record PlayedSound(String what, double startMs, Sound sound) {

    public double endMs() {
        return startMs + sound.lengthMs();
    }
}
