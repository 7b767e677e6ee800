package majicsim.aibo.urbi.run;

import java.util.List;
import majicsim.aibo.urbi.syntax.Statement;

/**
 * The replacement of a command by the kernel: it has the flags of the original command, a tag of the kernel, and the
 * original command never reports its end (URBI sheet, section 21).
 */
public final class Substitute extends Task {
    /** The tag of commands that the kernel makes itself. */
    static final String TAG = "__system__";

    private final Task command;

    Substitute(Context context, Task body) {
        super(context);
        command = new TaggedTask(body.context, context.flags(), body);
    }

    /** Returns the replacement of a command. */
    public static Substitute of(Context given, Statement command) {
        return new Substitute(given, context(given).start(command));
    }

    /** The context for the body of a substitute. */
    static Context context(Context given) {
        return given.inner(TAG, given.flags());
    }

    @Override
    protected boolean advance() {
        return command.step();
    }

    @Override
    public List<Task> parts() {
        return List.of(command);
    }

    @Override
    public boolean isReplaced() {
        return true;
    }
}
