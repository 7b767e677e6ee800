package majicsim.aibo;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import majicsim.net.Line;
import org.jspecify.annotations.Nullable;

/**
 * The URBI kernel: connections, variables, functions and the cycle in which everything runs. Its time is given from outside, in
 * milliseconds of the lab.
 */
final class Kernel {
    /** The cycle of the ERS-7 (URBI sheet, section 3). */
    static final double CYCLE_MS = 32;

    /** How long the server is up already when the lab starts: the stick's scripts took that long. */
    private static final double BOOT_MS = 4000;

    private static final long FIRST_ID = 138_240_016;
    private static final long ID_STEP = 5_264;

    private final Groups groups = new Groups();
    private final Variables variables = new Variables(groups);
    private final Functions functions = new Functions();
    private final Set<String> blocked = new HashSet<>();
    private final List<Connection> connections = new ArrayList<>();
    private final Connection own;
    private final Budget budget = new Budget();
    private double nowMs;
    private long pass;
    private long nextId = FIRST_ID;

    Kernel() {
        own = new Connection(this, newId(), null);
        connections.add(own);
    }

    Groups groups() {
        return groups;
    }

    Variables variables() {
        return variables;
    }

    Functions functions() {
        return functions;
    }

    Budget budget() {
        return budget;
    }

    List<Connection> connections() {
        return List.copyOf(connections);
    }

    double nowMs() {
        return nowMs;
    }

    double timestampMs() {
        return Math.floor(BOOT_MS + nowMs);
    }

    /** The number of the present run through the commands: a cycle, or the bytes of a client that just came. */
    long pass() {
        return pass;
    }

    void advanceTo(double ms) {
        nowMs = ms;
    }

    /** Runs a program of the stick in the kernel's own connection. */
    void load(String program) {
        own.received(program.getBytes(StandardCharsets.ISO_8859_1));
    }

    Connection connect(Line line) {
        Connection connection = new Connection(this, newId(), line);
        connections.add(connection);
        for (String text : Banner.lines()) {
            connection.send("start", text.isEmpty() ? "***" : "*** " + text);
        }
        connection.send("ident", "*** ID: " + connection.id());
        connection.flush();
        return connection;
    }

    void received(Line line, byte[] bytes) {
        pass++;
        Connection connection = find(line);
        if (connection != null) {
            connection.received(bytes);
            flush();
        }
    }

    void disconnected(Line line) {
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
        }
    }

    /** One cycle: every command that runs is stepped. */
    void cycle() {
        pass++;
        for (Connection connection : connections()) {
            connection.cycle();
        }
        for (Variable variable : variables.all()) {
            variable.sample(CYCLE_MS / 1000);
        }
        flush();
    }

    boolean isBlocked(String tag) {
        return blocked.contains(tag);
    }

    void block(String tag) {
        blocked.add(tag);
    }

    void unblock(String tag) {
        blocked.remove(tag);
    }

    /** Who hears an echo: nobody named is the speaker alone, otherwise all, other, or one by its name. */
    List<Connection> audience(Connection speaker, String named) {
        return switch (named) {
            case "" -> List.of(speaker);
            case "all" -> connections();
            case "other" -> connections.stream().filter(each -> each != speaker).toList();
            default ->
                connections.stream().filter(each -> each.id().equals(named)).toList();
        };
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
