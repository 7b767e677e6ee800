package majicsim.aibo.urbi;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import majicsim.net.Line;
import majicsim.world.Noise;
import org.jspecify.annotations.Nullable;

/**
 * The URBI kernel: connections, variables, functions and the cycle in which everything runs. Its time is given from outside, in
 * milliseconds of the lab.
 */
public final class Kernel {
    /** The cycle of the ERS-7 (URBI sheet, section 3). */
    public static final double CYCLE_MS = 32;

    /** How long the server is up already when the lab starts: the stick's scripts took that long. */
    private static final double BOOT_MS = 4000;

    private static final long FIRST_ID = 138_240_016;
    private static final long ID_STEP = 5_264;

    private final Groups groups = new Groups();
    private final Objects objects = new Objects();
    private final Variables variables = new Variables(groups, objects);
    private final Functions functions = new Functions(objects);
    private final Events events = new Events();
    private final Tags tags = new Tags();
    private final Restart restart = new Restart(this);
    private final List<Connection> connections = new ArrayList<>();
    private final Connection own;
    private final Budget budget = new Budget();
    private Consumer<Connection> greeting = connection -> {};
    private Map<String, Set<String>> systemGroups = Map.of();
    private String startScript = "";
    private double nowMs;
    private long pass;
    private long nextId = FIRST_ID;

    /**
     * A kernel that knows the language and no hardware yet.
     *
     * @param noise what {@code random} draws from
     */
    public Kernel(Noise noise) {
        own = new Connection(this, newId(), null);
        connections.add(own);
        BuiltIns.install(this, noise);
    }

    /**
     * The groups of variables.
     *
     * @return the same object always
     */
    public Groups groups() {
        return groups;
    }

    /**
     * The variables, to which the hardware adds its own before {@link Stick#insertInto}.
     *
     * @return the same object always
     */
    public Variables variables() {
        return variables;
    }

    /**
     * The functions, to which the hardware adds its own.
     *
     * @return the same object always
     */
    public Functions functions() {
        return functions;
    }

    Objects objects() {
        return objects;
    }

    Events events() {
        return events;
    }

    Tags tags() {
        return tags;
    }

    Restart restart() {
        return restart;
    }

    Budget budget() {
        return budget;
    }

    List<Connection> connections() {
        return List.copyOf(connections);
    }

    /**
     * What time it is.
     *
     * @return lab time since the robot was made, ms
     */
    public double nowMs() {
        return nowMs;
    }

    double timestampMs() {
        return Math.floor(BOOT_MS + nowMs);
    }

    /**
     * The present run through the commands: a cycle, or the bytes of a client that just came.
     *
     * @return its number, from 0
     */
    public long pass() {
        return pass;
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
    void greet(Consumer<Connection> newcomer) {
        greeting = newcomer;
    }

    /** Runs the stick's start script; what is there before it, is there after every reset. */
    void boot(String program) {
        variables.seal();
        systemGroups = groups.copy();
        startScript = program;
        load(program);
    }

    /** Runs a program of the stick in the kernel's own connection. */
    void load(String program) {
        own.received(program.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** Stops everything in every connection and forgets what programs made. */
    void forget() {
        connections().forEach(each -> each.stream().clear());
        variables.forget();
        functions.forget();
        groups.restore(systemGroups);
        objects.clear();
        events.removeAllOf("");
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
        Connection connection = new Connection(this, newId(), line);
        connections.add(connection);
        variables.putSystem(new Variable(connection.id() + ".connectionID", Value.of(connection.id())));
        for (String text : Banner.lines()) {
            connection.send("start", text.isEmpty() ? "***" : "*** " + text);
        }
        connection.send("ident", "*** ID: " + connection.id());
        connection.flush();
        greeting.accept(connection);
    }

    /**
     * Takes what a client said; what nothing holds back is done at once.
     *
     * @param line the client's
     * @param bytes in whatever pieces
     */
    public void received(Line line, byte[] bytes) {
        pass++;
        Connection connection = find(line);
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
        Connection connection = find(line);
        if (connection != null) {
            connection.stream().kill();
            remove(connection);
        }
    }

    void remove(Connection connection) {
        if (connections.remove(connection)) {
            variables.removeAllOf(connection.id());
            functions.removeAllOf(connection.id());
            events.removeAllOf(connection.id() + ".");
        }
    }

    /** One cycle: every command that runs is stepped. To be called each {@link #CYCLE_MS} of lab time. */
    public void cycle() {
        pass++;
        budget.beginCycle();
        restart.step();
        events.turn(nowMs);
        for (Connection connection : connections()) {
            connection.cycle();
        }
        for (Variable variable : variables.all()) {
            variable.sample(CYCLE_MS / 1000);
        }
        flush();
    }

    /** Who is meant by a name: nobody named is the speaker alone, otherwise all, other, or one by its own. */
    List<Connection> audience(Connection speaker, String named) throws Failure {
        List<Connection> meant = switch (named) {
            case "" -> List.of(speaker);
            case "all" -> connections();
            case "other" -> connections.stream().filter(each -> each != speaker).toList();
            default ->
                connections.stream().filter(each -> each.id().equals(named)).toList();
        };
        if (meant.isEmpty()) {
            throw Failure.of(named + ": no such connection");
        }
        return meant;
    }

    /** The client's connection of that name. */
    Connection client(String id) throws Failure {
        return connections.stream()
                .filter(each -> each != own && each.id().equals(id))
                .findFirst()
                .orElseThrow(() -> Failure.of(id + ": no such connection"));
    }

    private void flush() {
        connections().forEach(Connection::flush);
    }

    private @Nullable Connection find(Line line) {
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
