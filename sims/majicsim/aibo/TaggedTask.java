package majicsim.aibo;

import java.util.List;

/** A command under its tag, with the messages that its flags ask for (URBI sheet, section 7). */
final class TaggedTask extends Task {
    private final Task body;
    private final List<Flag> flags;
    private boolean begun;

    TaggedTask(Context context, List<Flag> flags, Statement body) {
        this(context, flags, body.start(context));
    }

    TaggedTask(Context context, List<Flag> flags, Task body) {
        super(context);
        this.flags = flags;
        this.body = body;
    }

    String tag() {
        return context.tag();
    }

    @Override
    protected boolean advance() {
        if (!begun) {
            begun = true;
            if (context.kernel().tags().isBlocked(tag())) {
                return true;
            }
            if (context.kernel().tags().isFrozen(tag())) {
                begun = false;
                return false;
            }
            warn();
            announce("begin");
        }
        // A command that stops its own tag is over before its body returns here: then it sends no end.
        boolean ended = body.step() && !isOver();
        if (ended) {
            announce("end");
        }
        return ended;
    }

    @Override
    protected List<Task> parts() {
        return List.of(body);
    }

    private void announce(String moment) {
        if (Flag.in(flags, moment) || Flag.in(flags, "report")) {
            context.info(moment);
        }
    }

    private void warn() {
        flags.stream()
                .filter(Flag::isObsolete)
                .forEach(flag -> context.error("Warning: flag '" + flag.name() + "' is obsolete"));
    }
}
