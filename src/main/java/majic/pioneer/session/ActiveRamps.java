package majic.pioneer.session;

import java.util.function.UnaryOperator;
import majic.pioneer.state.Limits;
import majic.pioneer.state.Model;
import majic.pioneer.state.Ramps;
import org.jspecify.annotations.Nullable;

/**
 * Holds the ramps in force over all sessions with one robot, which itself loses them at the end of each session (ARCOS
 * sheet 5.1). Thread-safe.
 */
public final class ActiveRamps {
    private Limits limits;
    private Ramps inForce;
    private @Nullable Ramps requested;

    /** Begins with the careful ramps of a model, until the robot has reported its limits. */
    public ActiveRamps(Model model) {
        limits = Limits.of(model, null);
        inForce = Ramps.careful(limits);
    }

    /**
     * Fits the ramps to the limits that a robot has reported: those that a user has set, as far as the limits allow, else
     * the careful ones.
     *
     * @return the ramps to send
     */
    synchronized Ramps fit(Limits found) {
        limits = found;
        inForce = requested == null ? Ramps.careful(found) : requested.within(found);
        return inForce;
    }

    /**
     * Changes the ramps for this session and later ones.
     *
     * @param change makes the requested ramps from those in force
     * @return the ramps to send, reduced to the limits where necessary
     */
    public synchronized Ramps change(UnaryOperator<Ramps> change) {
        requested = change.apply(inForce);
        return fit(limits);
    }

    /** The ramps that were last sent. */
    public synchronized Ramps ramps() {
        return inForce;
    }

    /** The upper bounds of the ramps. */
    public synchronized Limits limits() {
        return limits;
    }
}
