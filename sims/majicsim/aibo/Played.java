package majicsim.aibo;

/**
 * A sound that the dog's speaker played, or is still to play.
 *
 * @param what the file's name on the stick, or "sent" for one that a client sent
 * @param startMs when it begins or began, ms of lab time
 * @param sound all of it
 */
public record Played(String what, double startMs, Sound sound) {

    double endMs() {
        return startMs + sound.lengthMs();
    }
}
