package majicsim.aibo.urbi.assign;

import java.util.List;
import majicsim.aibo.urbi.memory.Blend;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Server;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Flag;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** An assignment of a number under way: at once, or along a trajectory; by the variable's blend mode. */
final class AssignTask extends Task implements Variable.Motion {
    private final Variable variable;
    private final TargetEvaluation target;
    private @Nullable Trajectory trajectory;
    private double beganMs;
    private double from;

    AssignTask(Context context, Variable variable, TargetEvaluation target) {
        super(context);
        this.variable = variable;
        this.target = target;
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
        } else if (target.renew()) {
            way = plan();
            trajectory = way;
        }
        Modifiers modifiers = target.current().modifiers();
        double elapsedMs = elapsedMs() - beganMs;
        if (elapsedMs >= modifiers.get("timelimit", Double.POSITIVE_INFINITY)) {
            variable.submit(now(), context.server().pass());
            return true;
        }
        return modifiers.isAdaptive() ? pursue(elapsedMs) : follow(way, elapsedMs);
    }

    private boolean follow(Trajectory way, double elapsedMs) {
        variable.submit(way.curve().at(elapsedMs), context.server().pass());
        Variable phase = target.current().modifiers().phase();
        if (phase != null) {
            phase.write(Value.of(way.phase().at(elapsedMs)));
        }
        return elapsedMs >= way.durationMs();
    }

    /** Plans this cycle from the measured position, {@code adaptive:1} (URBI sheet, section 6). */
    private boolean pursue(double elapsedMs) {
        double to = variable.properties().clip(target.current().value());
        double way = to - now();
        double stride = Math.min(Math.abs(way), stride(Math.abs(way), elapsedMs));
        variable.submit(now() + Math.signum(way) * stride, context.server().pass());
        return Math.abs(now() - to) <= variable.properties().number("delta");
    }

    private double stride(double way, double elapsedMs) {
        Modifiers modifiers = target.current().modifiers();
        if (modifiers.has("time")) {
            double leftMs = Math.abs(modifiers.get("time", 0)) - elapsedMs;
            return leftMs <= Server.CYCLE_MS ? way : way * Server.CYCLE_MS / leftMs;
        }
        return Math.abs(modifiers.get("speed", 0)) * Server.CYCLE_MS / 1000;
    }

    private double now() {
        return variable.read() instanceof Value.Num num
                ? num.number()
                : target.current().value();
    }

    @Override
    protected void ended() {
        variable.motions().remove(this);
    }

    @Override
    public void cancel() {
        kill();
    }

    private boolean isDiscarded() {
        return variable.properties().blend() == Blend.DISCARD
                && !variable.motions().isEmpty();
    }

    private boolean isQueued() {
        List<Variable.Motion> motions = variable.motions();
        if (variable.properties().blend() != Blend.QUEUE) {
            return false;
        }
        if (!motions.contains(this)) {
            motions.add(this);
        }
        return motions.get(0) != this;
    }

    private Trajectory begin() {
        List<Variable.Motion> motions = variable.motions();
        if (variable.properties().blend() == Blend.CANCEL) {
            List.copyOf(motions).forEach(Variable.Motion::cancel);
        }
        if (!motions.contains(this)) {
            motions.add(this);
        }
        beganMs = elapsedMs();
        from = variable.target() instanceof Value.Num now
                ? now.number()
                : target.current().value();
        Trajectory way = plan();
        trajectory = way;
        return way;
    }

    private Trajectory plan() {
        double to = variable.properties().clip(target.current().value());
        Trajectory way = Trajectory.of(from, to, target.current().modifiers());
        return Double.isFinite(way.durationMs()) ? within(way, to) : way;
    }

    /** The same way not faster than speedmax and not slower than speedmin. */
    private Trajectory within(Trajectory way, double to) {
        double speedMax = variable.properties().number("speedmax");
        double speedMin = variable.properties().number("speedmin");
        Trajectory fast = speedMin > 0 ? Trajectory.paced(from, to, speedMin) : way;
        Trajectory slow = speedMax > 0 && speedMax < Value.INFINITY ? Trajectory.paced(from, to, speedMax) : way;
        if (slow.durationMs() > way.durationMs()) {
            warn("Warning: request exceeds speedmax. Enforcing limitation");
            return slow;
        }
        if (fast.durationMs() < way.durationMs()) {
            warn("low speed: increased to speedmin");
            return fast;
        }
        return way;
    }

    /** At the start only: a way that is planned again was warned of already. */
    private void warn(String text) {
        if (Flag.in(context.flags(), "error") && trajectory == null) {
            context.error(text);
        }
    }
}
