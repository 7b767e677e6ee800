package majicsim.aibo.urbi.run;

import java.util.List;
import majicsim.aibo.urbi.memory.Frame;
import majicsim.aibo.urbi.memory.Memory;
import majicsim.aibo.urbi.memory.Scope;
import majicsim.aibo.urbi.memory.Variables;
import majicsim.aibo.urbi.syntax.Flag;
import majicsim.aibo.urbi.syntax.Statement;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/**
 * The connection, call, tag and flags with which a command runs. Immutable.
 *
 * @param connection the connection that sent it
 * @param frame the call it belongs to; null outside of one
 * @param tag that its replies carry
 * @param depth the number of commands around it, including function calls
 * @param flags of the command, also valid for its replacement
 */
public record Context(Connection connection, @Nullable Frame frame, String tag, int depth, List<Flag> flags) {
    /** Returns the context of a command inside this one. */
    public Context inner(String itsTag) {
        return inner(itsTag, List.of());
    }

    /** Returns the context of a command inside this one with its own flags. */
    public Context inner(String itsTag, List<Flag> itsFlags) {
        return new Context(connection, frame, itsTag, depth + 1, itsFlags);
    }

    Context withFrame(Frame other) {
        return new Context(connection, other, tag, depth, flags);
    }

    /**
     * The server that runs it.
     *
     * @return the one of its connection
     */
    public Server server() {
        return connection.server();
    }

    public Memory memory() {
        return server().memory();
    }

    public Variables variables() {
        return memory().variables();
    }

    public Functions functions() {
        return server().functions();
    }

    public Scope scope() {
        return new Scope(connection.id(), frame);
    }

    /** Returns the task of a command inside this one, not started. */
    public Task start(Statement statement) {
        return server().start(this, statement);
    }

    double nowMs() {
        return server().nowMs();
    }

    /** Whether the surrounding function has returned, so that the rest of it must not run. */
    public boolean isLeft() {
        return frame != null && frame.hasReturned();
    }

    public void reply(Value value) {
        connection.reply(tag, value);
    }

    public void info(String text) {
        connection.send(tag, "*** " + text);
    }

    public void error(String text) {
        connection.send(tag, "!!! " + text);
    }

    public void report(Failure failure) {
        failure.lines().forEach(this::error);
    }
}
