package majicsim.aibo.urbi.run;

import java.util.List;
import majicsim.aibo.urbi.syntax.Flag;

/** A command with its tag, and with the messages that its flags request (URBI sheet, section 7). */
public final class TaggedTask extends Task {
    private final Task body;
    private final List<Flag> flags;
    private boolean begun;

    public TaggedTask(Context context, List<Flag> flags, Task body) {
        super(context);
        this.flags = flags;
        this.body = body;
    }

    public String tag() {
        return context.tag();
    }

    @Override
    protected boolean advance() {
        boolean first = !begun;
        if (first && context.server().tags().isBlocked(tag())) {
            return true;
        }
        if (first && context.server().tags().isFrozen(tag())) {
            return false;
        }
        if (first) {
            begun = true;
            warn();
            announce("begin");
        }
        // A command that stops its own tag is over before its body returns here: then it sends no end.
        boolean ended = body.step() && !isOver();
        if (ended && !wasReplaced()) {
            announce("end");
        }
        return ended || !mayGoOn(first);
    }

    /** Fails a command that does not end at once if too many commands are running. */
    private boolean mayGoOn(boolean isNew) {
        Budget budget = context.server().budget();
        if (isNew && budget.isCrowded()) {
            context.connection().overloaded();
            return false;
        }
        budget.countRunning();
        return true;
    }

    @Override
    public List<Task> parts() {
        return List.of(body);
    }

    /** Whether the kernel has replaced it; then its tag applies only to the parts of the replacement. */
    public boolean wasReplaced() {
        return body.isReplaced();
    }

    private void announce(String moment) {
        if (Flag.in(flags, moment) || Flag.in(flags, "report")) {
            context.info(moment);
        }
    }

    private void warn() {
        for (Flag flag : flags) {
            String warning = flag.warning();
            if (warning != null) {
                context.error(warning);
            }
        }
    }
}
