package majic.aibo.body;

import java.util.EnumMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRequest;
import majic.aibo.urbi.UrbiValue;
import majic.aibo.urbi.UrbiVersion;

/**
 * The variables on the dog that hold the pace of its legs. All its clients share them, so their former values are
 * restored; if a connection breaks, by the next one. Thread-safe.
 */
public final class LegSpeed {
    private static final Gait[] ONE_FOR_EACH_VARIABLE = {Gait.FORWARD, Gait.LEFT};

    private final Map<Gait, UrbiRequest> found = new EnumMap<>(Gait.class);
    private final Set<String> changed = new HashSet<>();

    /** Asks for their values on a connection; does not wait for the answers. */
    public synchronized void look(UrbiConnection connection, Tags tags) {
        for (Gait gait : ONE_FOR_EACH_VARIABLE) {
            if (changed.contains(gait.paceVariable())) {
                continue;
            }
            found.put(gait, connection.ask(tags, gait.paceVariable()));
        }
    }

    /** What sets the pace for a piece of a gait, to be sent right before it: another client may have changed it. */
    public synchronized String order(Stride stride) {
        changed.add(stride.gait().paceVariable());
        return stride.order();
    }

    /** The commands that restore those that were changed and whose former values the dog has reported. */
    public synchronized String restore() {
        StringBuilder commands = new StringBuilder();
        found.forEach((gait, ask) -> {
            if (changed.contains(gait.paceVariable())
                    && ask.value() instanceof UrbiValue.Num number
                    && number.amount() > 0) {
                commands.append(' ').append(gait.paceVariable()).append(" = ");
                commands.append(UrbiVersion.number(number.amount())).append(',');
            }
        });
        changed.clear();
        return commands.toString();
    }
}
