package majicsim.aibo.urbi;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import majicsim.aibo.urbi.command.TaskFactory;
import majicsim.aibo.urbi.memory.Memory;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.run.Budget;
import majicsim.aibo.urbi.run.Connection;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Functions;
import majicsim.aibo.urbi.run.Server;
import majicsim.aibo.urbi.run.Tags;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Statement;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import majicsim.net.Line;
import majicsim.world.Noise;
import org.jspecify.annotations.Nullable;

/**
 * The URBI kernel: connections, variables, functions and the cycle in which everything runs. Its caller sets its time,
 * in milliseconds of the lab.
 */
public final class Kernel implements Server {
    /** The uptime of the server when the lab starts: the duration of the stick's scripts. */
    private static final double BOOT_MS = 4000;

    private static final long FIRST_ID = 138_240_016;
    private static final long ID_STEP = 5_264;

    private final Memory memory = new Memory(CYCLE_MS);
    private final Functions functions = new Functions(memory.objects());
    private final Tags tags = new Tags();
    private final Restart restart = new Restart(this);
    private final List<ClientConnection> connections = new ArrayList<>();
    private final ClientConnection own;
    private final Budget budget = new Budget();
    private Consumer<ClientConnection> greeting = connection -> {};
    private String startScript = "";
    private double nowMs;
    private long pass;
    private long nextId = FIRST_ID;

    /**
     * A kernel with the language and no hardware yet.
     *
     * @param noise the source of {@code random}
     */
    public Kernel(Noise noise) {
        own = new ClientConnection(this, newId(), null);
        connections.add(own);
        BuiltIns.install(functions, noise, this::timestampMs);
    }

    @Override
    public Memory memory() {
        return memory;
    }

    @Override
    public Functions functions() {
        return functions;
    }

    @Override
    public Tags tags() {
        return tags;
    }

    @Override
    public Budget budget() {
        return budget;
    }

    @Override
    public List<Connection> connections() {
        return List.copyOf(connections);
    }

    @Override
    public double nowMs() {
        return nowMs;
    }

    @Override
    public double timestampMs() {
        return Math.floor(BOOT_MS + nowMs);
    }

    @Override
    public long pass() {
        return pass;
    }

    @Override
    public Task start(Context context, Statement statement) {
        return statement.accept(new TaskFactory(context));
    }

    @Override
    public void reset() {
        restart.request();
    }

    /**
     * Advances the time; nothing runs before the next {@link #cycle}.
     *
     * @param ms lab time, not before {@link #nowMs}
     */
    public void advanceTo(double ms) {
        nowMs = ms;
    }

    /** Sets the program that runs in each new connection, like the stick's CLIENT.INI. */
    void onConnect(Consumer<ClientConnection> program) {
        greeting = program;
    }

    /** Runs the stick's start script; everything that exists before it exists after every reset. */
    void boot(String program) {
        memory.seal();
        startScript = program;
        load(program);
    }

    /** Runs a program of the stick in the kernel's own connection. */
    void load(String program) {
        own.received(program.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** Stops everything in every connection and removes everything that programs made. */
    void forget() {
        connections().forEach(Connection::clear);
        memory.forget();
        functions.forget();
        tags.clear();
    }

    /** Runs the stick's program again, and in each connection the program of new connections. */
    void reload() {
        load(startScript);
        connections.stream().filter(each -> each.line() != null).forEach(greeting);
    }

    /**
     * Greets a new client: sends the banner, then runs the stick's program for new connections.
     *
     * @param line the client's, open
     */
    public void connect(Line line) {
        ClientConnection connection = new ClientConnection(this, newId(), line);
        connections.add(connection);
        memory.variables().putSystem(new Variable(connection.id() + ".connectionID", Value.of(connection.id())));
        for (String text : Banner.lines()) {
            connection.send("start", text.isEmpty() ? "***" : "*** " + text);
        }
        connection.send("ident", "*** ID: " + connection.id());
        connection.flush();
        greeting.accept(connection);
    }

    /**
     * Takes bytes from a client; commands that need not wait run at once.
     *
     * @param line the client's
     * @param bytes in pieces of any size
     */
    public void received(Line line, byte[] bytes) {
        pass++;
        ClientConnection connection = find(line);
        if (connection != null) {
            connection.received(bytes);
            flush();
        }
    }

    /**
     * Ends everything that a client has left running and removes its variables.
     *
     * @param line the client's, closed
     */
    public void disconnected(Line line) {
        ClientConnection connection = find(line);
        if (connection != null) {
            connection.end();
        }
    }

    void remove(ClientConnection connection) {
        if (connections.remove(connection)) {
            memory.removeAllOf(connection.id());
            functions.removeAllOf(connection.id());
        }
    }

    /** Runs one cycle: steps every running command. To be called every {@link #CYCLE_MS} of lab time. */
    public void cycle() {
        pass++;
        budget.beginCycle();
        restart.step();
        memory.events().turn(nowMs);
        for (ClientConnection connection : List.copyOf(connections)) {
            connection.cycle();
        }
        for (Variable variable : memory.variables().moving()) {
            variable.sample(CYCLE_MS / 1000);
        }
        flush();
    }

    @Override
    public List<Connection> recipients(Connection sender, String named) throws Failure {
        List<Connection> meant = switch (named) {
            case "" -> List.of(sender);
            case "all" -> connections();
            case "other" ->
                connections().stream().filter(each -> each != sender).toList();
            default ->
                connections().stream().filter(each -> each.id().equals(named)).toList();
        };
        if (meant.isEmpty()) {
            throw Failure.of(named + ": no such connection");
        }
        return meant;
    }

    private void flush() {
        List.copyOf(connections).forEach(ClientConnection::flush);
    }

    private @Nullable ClientConnection find(Line line) {
        return connections.stream()
                .filter(each -> each.line() == line)
                .findFirst()
                .orElse(null);
    }

    private String newId() {
        nextId += ID_STEP;
        return "U" + nextId;
    }
}
