package majic.aibo.session;

import java.util.List;
import majic.aibo.urbi.AiboLinks;
import majic.aibo.urbi.DogClock;
import majic.aibo.urbi.Pulse;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.Watch;

/** Finds out that a dog no longer says or hears anything. Used by the keeper's thread. */
final class Vigil {
    /** After so much silence a dog must not move. */
    static final double SILENCE_S = 1.5;

    private static final double LOST_S = 4;

    private final AiboLinks links;
    private final Hearing hearing;
    private final List<Pulse> pulses;
    private boolean told;

    /** Begins to watch links that are open. */
    Vigil(AiboLinks links, Hearing hearing, Tags tags, Watch watch, DogClock clock) {
        this.links = links;
        this.hearing = hearing;
        this.pulses =
                List.of(new Pulse(links.motion(), tags, watch, clock), new Pulse(links.stop(), tags, watch, clock));
    }

    /** Breaks the connection if it does not reach the dog any more. */
    void tend() {
        if (hearing.silenceS() > LOST_S) {
            links.broken(links.sensors(), "no word from the dog for " + (int) LOST_S + " s");
        }
        for (Pulse pulse : pulses) {
            if (!pulse.beats()) {
                links.broken(pulse.connection(), Pulse.silence());
            }
        }
    }

    /** Whether a silence has begun that nobody was told of yet. */
    boolean fallsSilent() {
        boolean silent = hearing.silenceS() > SILENCE_S;
        boolean tell = silent && !told;
        told = silent;
        return tell;
    }
}
