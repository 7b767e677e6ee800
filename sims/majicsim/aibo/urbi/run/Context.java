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
 * @param connection from which it came
 * @param frame the call it belongs to; null outside of one
 * @param tag that its replies carry
 * @param depth how many commands it is inside of, through all function calls
 * @param flags of the command, which also stand before what the kernel runs in place of it
 */
public record Context(Connection connection, @Nullable Frame frame, String tag, int depth, List<Flag> flags) {
    /** For a command inside this one. */
    public Context inner(String itsTag) {
        return inner(itsTag, List.of());
    }

    /** For a command inside this one with flags of its own. */
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

    /** A run of a command inside this one; nothing happens before its first step. */
    public Task start(Statement statement) {
        return server().start(this, statement);
    }

    double nowMs() {
        return server().nowMs();
    }

    /** Whether the function that this is a part of has returned, so that nothing further of it may run. */
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
