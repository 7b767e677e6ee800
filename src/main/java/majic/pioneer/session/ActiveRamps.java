package majic.pioneer.session;

import java.util.function.UnaryOperator;
import majic.pioneer.state.Limits;
import majic.pioneer.state.Model;
import majic.pioneer.state.Ramps;
import org.jspecify.annotations.Nullable;

/**
 * The one place that knows which ramps are in force, over all sessions with one robot: it forgets them at the end of each
 * (ARCOS sheet 5.1). Thread-safe.
 */
public final class ActiveRamps {
    private Limits limits;
    private Ramps inForce;
    private @Nullable Ramps wanted;

    /** The careful ones of a model, before anything is known of the robot itself. */
    public ActiveRamps(Model model) {
        limits = Limits.of(model, null);
        inForce = Ramps.careful(limits);
    }

    /**
     * Fits them to a robot that has told its limits: what was wanted before as far as it goes, else the careful ones.
     *
     * @return those to tell the robot
     */
    synchronized Ramps fit(Limits found) {
        limits = found;
        inForce = wanted == null ? Ramps.careful(found) : wanted.within(found);
        return inForce;
    }

    /**
     * Takes over what somebody wants, for this session and those to come.
     *
     * @param change makes those that are wanted of those in force
     * @return those to tell the robot, which may be slower
     */
    public synchronized Ramps change(UnaryOperator<Ramps> change) {
        wanted = change.apply(inForce);
        return fit(limits);
    }

    /** Those that the robot was told. */
    public synchronized Ramps ramps() {
        return inForce;
    }

    /** How far they may be raised. */
    public synchronized Limits limits() {
        return limits;
    }
}
