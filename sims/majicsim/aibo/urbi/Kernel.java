package majicsim.aibo.urbi;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import majicsim.aibo.urbi.command.Starter;
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
 * The URBI kernel: connections, variables, functions and the cycle in which everything runs. Its time is given from outside, in
 * milliseconds of the lab.
 */
public final class Kernel implements Server {
    /** How long the server is up already when the lab starts: the stick's scripts took that long. */
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
     * @param noise what {@code random} draws from
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
        return statement.accept(new Starter(context));
    }

    @Override
    public void reset() {
        restart.order();
    }

    /**
     * Lets time go on; nothing is done before the next {@link #cycle}.
     *
     * @param ms lab time, not before {@link #nowMs}
     */
    public void advanceTo(double ms) {
        nowMs = ms;
    }

    /** What runs in each new connection, as the stick's CLIENT.INI does. */
    void greet(Consumer<ClientConnection> newcomer) {
        greeting = newcomer;
    }

    /** Runs the stick's start script; what is there before it, is there after every reset. */
    void boot(String program) {
        memory.seal();
        startScript = program;
        load(program);
    }

    /** Runs a program of the stick in the kernel's own connection. */
    void load(String program) {
        own.received(program.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** Stops everything in every connection and forgets what programs made. */
    void forget() {
        connections().forEach(Connection::clear);
        memory.forget();
        functions.forget();
        tags.clear();
    }

    /** Runs the stick's program again, and in each connection what a new one has. */
    void reload() {
        load(startScript);
        connections.stream().filter(each -> each.line() != null).forEach(greeting);
    }

    /**
     * Greets a client that has come: the banner, then what the stick has for each.
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
     * Takes bytes of a client; commands that do not have to wait run at once.
     *
     * @param line the client's
     * @param bytes in whatever pieces
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
     * Ends all that a client has left running and forgets what was its own.
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

    /** One cycle: every command that runs is stepped. To be called each {@link #CYCLE_MS} of lab time. */
    public void cycle() {
        pass++;
        budget.beginCycle();
        restart.step();
        memory.events().turn(nowMs);
        for (ClientConnection connection : List.copyOf(connections)) {
            connection.cycle();
        }
        for (Variable variable : memory.variables().all()) {
            variable.sample(CYCLE_MS / 1000);
        }
        flush();
    }

    @Override
    public List<Connection> audience(Connection speaker, String named) throws Failure {
        List<Connection> meant = switch (named) {
            case "" -> List.of(speaker);
            case "all" -> connections();
            case "other" ->
                connections().stream().filter(each -> each != speaker).toList();
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
