package majicsim.aibo;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** An assignment of a number under way: at once, or along a trajectory; it heeds the variable's blend mode. */
final class AssignTask extends Task {
    private final Variable variable;
    private final double target;
    private final Map<String, Double> modifiers;
    private @Nullable Trajectory trajectory;
    private double beganMs;

    AssignTask(Context context, Variable variable, double target, Map<String, Double> modifiers) {
        super(context);
        this.variable = variable;
        this.target = target;
        this.modifiers = modifiers;
    }

    @Override
    protected boolean advance() {
        Trajectory way = trajectory;
        if (way == null) {
            if (isDiscarded()) {
                return true;
            }
            if (isQueued()) {
                return false;
            }
            way = begin();
        }
        double elapsedMs = elapsedMs() - beganMs;
        variable.submit(way.curve().at(elapsedMs), context.kernel().pass());
        return elapsedMs >= way.durationMs();
    }

    @Override
    protected void ended() {
        variable.motions().remove(this);
    }

    private boolean isDiscarded() {
        return variable.properties().blend() == Blend.DISCARD
                && !variable.motions().isEmpty();
    }

    private boolean isQueued() {
        List<Task> motions = variable.motions();
        if (variable.properties().blend() != Blend.QUEUE) {
            return false;
        }
        if (!motions.contains(this)) {
            motions.add(this);
        }
        return motions.get(0) != this;
    }

    private Trajectory begin() {
        List<Task> motions = variable.motions();
        if (variable.properties().blend() == Blend.CANCEL) {
            List.copyOf(motions).forEach(Task::kill);
        }
        if (!motions.contains(this)) {
            motions.add(this);
        }
        beganMs = elapsedMs();
        Trajectory way = plan(variable.target() instanceof Value.Num now ? now.number() : target);
        trajectory = way;
        return way;
    }

    private Trajectory plan(double from) {
        double clipped = variable.properties().clip(target);
        Trajectory way = Trajectory.of(from, clipped, modifiers);
        double speedMax = variable.properties().speedMax();
        if (speedMax < Value.INFINITY && speedMax > 0 && Double.isFinite(way.durationMs())) {
            Trajectory slow = Trajectory.limited(from, clipped, speedMax);
            return slow.durationMs() > way.durationMs() ? slow : way;
        }
        return way;
    }
}
