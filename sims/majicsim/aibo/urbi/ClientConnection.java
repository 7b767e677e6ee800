package majicsim.aibo.urbi;

import java.nio.charset.StandardCharsets;
import java.util.List;
import majicsim.aibo.urbi.run.CommandStream;
import majicsim.aibo.urbi.run.Connection;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Server;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Action;
import majicsim.aibo.urbi.syntax.CommandReader;
import majicsim.aibo.urbi.syntax.Place;
import majicsim.aibo.urbi.syntax.SeparatedStatement;
import majicsim.aibo.urbi.syntax.Statement;
import majicsim.aibo.urbi.value.Value;
import majicsim.net.Line;
import org.jspecify.annotations.Nullable;

/** The connection of one client: its command stream, its identity and the data sent to it. */
final class ClientConnection implements Connection {
    /** The stick's CLIENT.INI has run in the connection before the client's first line (URBI sheet, section 11). */
    private static final Place FIRST_PLACE = new Place(19, 1);

    private static final int STAMP_DIGITS = 8;
    private static final int MAX_PREFIX = 1024;
    private static final int MAX_WAITING = 20_000;
    private static final int MAX_BINARY = 4 << 20;

    private final Kernel kernel;
    private final String id;
    private final @Nullable Line line;
    private final CommandReader reader = new CommandReader(FIRST_PLACE, problem -> send("error", "!!! " + problem));
    private final CommandStream stream;
    private final SendBuffer outbox;
    private Action.@Nullable AssignBinary binary;
    private boolean closing;
    private long refusedInPass = -1;

    /** @param line the client, or null for the kernel's own connection */
    ClientConnection(Kernel kernel, String id, @Nullable Line line) {
        this.kernel = kernel;
        this.id = id;
        this.line = line;
        stream = new CommandStream(context());
        outbox = new SendBuffer(line, () -> prefix("error") + "!!! Send buffer full\n");
    }

    @Override
    public Server server() {
        return kernel;
    }

    @Override
    public String id() {
        return id;
    }

    @Nullable
    Line line() {
        return line;
    }

    @Override
    public Task commands() {
        return stream;
    }

    @Override
    public void adopt(Task task) {
        stream.adopt(task);
    }

    @Override
    public void clear() {
        stream.clear();
    }

    @Override
    public Context context() {
        return new Context(this, null, Statement.NO_TAG, 0, List.of());
    }

    @Override
    public String describe() {
        String peer = line == null ? "0.0.0.0" : line.peer();
        int port = peer.lastIndexOf(':');
        return id + " (" + (port < 0 ? peer : peer.substring(0, port)) + ")";
    }

    /** Takes bytes from the client; complete commands start unless they must wait. */
    void received(byte[] bytes) {
        reader.feed(bytes);
        boolean more = true;
        while (more && !closing) {
            more = binary != null ? takeBinary(binary) : takeCommand();
        }
        flush();
    }

    private boolean takeCommand() {
        boolean arrived = reader.isAtCommand();
        SeparatedStatement step = arrived ? reader.take() : null;
        if (step != null && step.statement() instanceof Action.AssignBinary announced) {
            announce(announced);
        } else if (step != null) {
            run(step);
        }
        return arrived;
    }

    private boolean takeBinary(Action.AssignBinary waiting) {
        byte[] bytes = reader.take(waiting.size());
        if (bytes == null) {
            return false;
        }
        binary = null;
        Statement filled = waiting.filled(new String(bytes, StandardCharsets.ISO_8859_1));
        run(new SeparatedStatement(new Statement.Tagged(Statement.NO_TAG, List.of(), filled), false));
        return true;
    }

    private void announce(Action.AssignBinary announced) {
        if (announced.size() > MAX_BINARY) {
            send("error", "!!! Receive buffer full");
        } else {
            binary = announced;
        }
    }

    private void run(SeparatedStatement step) {
        if (stream.waiting() >= MAX_WAITING) {
            send("error", "!!! Out of memory");
        } else if (!(step.statement() instanceof Statement.Empty)) {
            stream.add(step);
        }
    }

    /** Steps everything that runs in this connection. */
    void cycle() {
        stream.step();
        flush();
    }

    @Override
    public void reply(String tag, Value value) {
        outbox.write(value.weight(), () -> prefix(tag) + value.print() + (value instanceof Value.Binary ? "" : "\n"));
    }

    @Override
    public void send(String tag, String body) {
        outbox.write(body.length(), () -> prefix(tag) + body + "\n");
    }

    @Override
    public void overloaded() {
        if (refusedInPass != kernel.pass()) {
            refusedInPass = kernel.pass();
            send("error", "!!! CPU Overload");
        }
    }

    @Override
    public void quit() {
        closing = true;
        stream.kill();
        flush();
        if (line != null) {
            line.close();
        }
        kernel.remove(this);
    }

    /** Ends its commands and itself after the client has disconnected. */
    void end() {
        stream.kill();
        kernel.remove(this);
    }

    void flush() {
        outbox.flush();
    }

    private String prefix(String tag) {
        String stamp = Long.toString((long) kernel.timestampMs());
        String prefix = "[" + "0".repeat(Math.max(0, STAMP_DIGITS - stamp.length())) + stamp + ":" + tag + "] ";
        return prefix.length() > MAX_PREFIX ? prefix.substring(0, MAX_PREFIX) : prefix;
    }
}
