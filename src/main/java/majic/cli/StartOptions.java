package majic.cli;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import majic.bot.BotException;
import majic.program.FirstRobots;
import majic.program.Program;
import majic.program.UsageException;
import majic.program.UserFolder;
import majic.server.LineServer;
import majic.server.ListenKey;
import majic.server.ListenToken;
import majic.simulation.SimulatedLab;
import majic.team.Team;
import majic.vendor.VendorLibrary;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;

/** The options of every start of a session: a lab, robots, a port to listen at. */
final class StartOptions implements FirstRobots.Source {
    @Option(
            names = "--lab",
            scope = ScopeType.INHERIT,
            description = "Start the simulated lab and add its three robots.")
    private boolean lab;

    @Mixin
    private LabChoice choice = new LabChoice();

    @Option(
            names = "--add",
            paramLabel = "URI",
            scope = ScopeType.INHERIT,
            description = "Add a robot, such as pioneer://10.0.0.5; repeatable.")
    private List<String> robots = new ArrayList<>();

    @Option(
            names = "--max-robots",
            paramLabel = "N",
            scope = ScopeType.INHERIT,
            description = "How many robots the team may have, 1 to " + Team.MOST_BOTS + " (" + Team.MAX_BOTS + ").")
    private int maxRobots = Team.MAX_BOTS;

    @Option(
            names = "--aria-home",
            paramLabel = "DIR",
            scope = ScopeType.INHERIT,
            description = "Where MobileRobots' ARIA is installed, for pioneer+aria://10.0.0.5.")
    private @Nullable String ariaHome;

    @Option(
            names = "--liburbi-home",
            paramLabel = "DIR",
            scope = ScopeType.INHERIT,
            description = "Where URBI's liburbi-java is installed, for aibo+liburbi://192.168.1.20.")
    private @Nullable String liburbiHome;

    @Option(
            names = "--listen",
            paramLabel = "HOST:PORT",
            scope = ScopeType.INHERIT,
            description = "Take lines of MAJIC Script over a socket, such as 127.0.0.1:7777, and answer in lines."
                    + " At another address: with TLS; see the command key.")
    private @Nullable String listen;

    @Option(
            names = "--listen-open",
            scope = ScopeType.INHERIT,
            description = "With --listen: obey any program on this machine, without a token.")
    private boolean open;

    @Mixin
    private SharingChoice sharing = new SharingChoice();

    @Option(names = "--no-recording", scope = ScopeType.INHERIT, description = "Do not record what the robots report.")
    private boolean unrecorded;

    void useLab(boolean wanted) {
        lab = wanted;
    }

    /** Returns the options of the lab, where nothing else is to be started. */
    LabChoice labAlone() {
        if (lab || listen != null || !robots.isEmpty() || maxRobots != Team.MAX_BOTS || sharing.isGiven()) {
            throw new UsageException(
                    "lab runs the simulators alone; --lab, --add, --listen, --max-robots and --share do not go with it");
        }
        return choice;
    }

    /**
     * Builds the program that these options request.
     *
     * @param folder the user's folder
     * @param windowFirst whether {@link #firstRobots} starts the usual lab, so that the window is visible before; a lab
     *     with options of its own is started at once, so that its faults end the program
     * @return the program, its robots not yet added
     * @throws UsageException if they do not go together
     * @throws IOException if the lab or the socket cannot open its ports, the world is none, or a file cannot be
     *     written
     */
    Program program(UserFolder folder, boolean windowFirst) throws IOException {
        if (open && listen == null) {
            throw new UsageException("--listen-open goes with --listen, as in --listen 127.0.0.1:7777 --listen-open");
        }
        if (!lab && choice.isGiven()) {
            throw new UsageException("the options of the simulated lab need --lab, as in majic --lab --exact");
        }
        if (maxRobots < 1 || maxRobots > Team.MOST_BOTS) {
            throw new UsageException("--max-robots " + maxRobots + ": outside 1 … " + Team.MOST_BOTS);
        }
        sharing.check();
        name(VendorLibrary.ARIA, ariaHome);
        name(VendorLibrary.LIBURBI, liburbiHome);
        boolean atOnce = lab && !(windowFirst && !choice.isGiven());
        SimulatedLab simulated = atOnce ? SimulatedLab.scaled(choice.options(), choice.speed()) : null;
        if (simulated != null) {
            choice.reportTakenPorts(simulated.simulators().addresses());
        }
        Program program = new Program(folder, simulated, !unrecorded, maxRobots);
        program.closeWhenProgramEnds();
        if (listen != null) {
            print(program, listen(program, address("--listen", listen, "127.0.0.1:7777")));
        }
        startSharing(program);
        return program;
    }

    private void startLab(Program program) {
        program.startLab();
        choice.reportTakenPorts(
                Objects.requireNonNull(program.lab()).simulators().addresses());
    }

    private void startSharing(Program program) throws IOException {
        try {
            sharing.start(program);
        } catch (IOException | RuntimeException e) {
            program.close();
            throw e;
        }
    }

    private static void name(VendorLibrary library, @Nullable String home) {
        if (home != null) {
            System.setProperty(library.property(), home);
        }
    }

    private LineServer listen(Program program, InetSocketAddress address) throws IOException {
        try {
            return program.listen(address, open ? null : token(program.folder()));
        } catch (IllegalArgumentException e) {
            throw new UsageException("--listen: " + e.getMessage());
        }
    }

    /** Returns what makes the token: the one that the user has chosen, or a new one. */
    private static LineServer.TokenMaker token(UserFolder folder) {
        String chosen = System.getenv(ListenToken.VARIABLE);
        if (chosen == null || chosen.isEmpty()) {
            return port -> ListenToken.create(folder.path(), port);
        }
        ListenToken token = ListenToken.chosen(chosen);
        return port -> token;
    }

    /** Prints the server's address to the standard error, since the standard output is for answers. */
    private static void print(Program program, LineServer server) {
        String clients = server.token().map(StartOptions::tokenHint).orElse("any program on this machine is obeyed");
        System.err.println("majic: listening at port " + server.port() + "; " + clients);
        if (server.isEncrypted()) {
            System.err.println("majic: programs on other computers use TLS and check the certificate "
                    + program.folder().file(ListenKey.CERTIFICATE));
            server.certificateWarning().ifPresent(text -> System.err.println("majic: " + text));
        }
    }

    private static String tokenHint(ListenToken token) {
        return token.file() == null
                ? "clients first send the token that is in " + ListenToken.VARIABLE
                : "clients first send the token " + token.word() + ", which is also in " + token.file();
    }

    /**
     * Returns the requested robots, once the requested lab runs. May block.
     *
     * @param program the built program
     * @return those of the lab, and those of {@code --add}
     * @throws BotException if the lab cannot be started now
     */
    @Override
    public FirstRobots firstRobots(Program program) {
        if (lab && program.lab() == null) {
            startLab(program);
        }
        SimulatedLab simulated = program.lab();
        return new FirstRobots(
                simulated == null ? List.of() : labLines(simulated.robots(), maxRobots),
                robots.stream().map(robot -> "add " + robot).toList());
    }

    /** Adds as many robots of the lab as a team has numbers. */
    static List<String> labLines(List<String> robots, int maxRobots) {
        return IntStream.range(0, Math.min(maxRobots, robots.size()))
                .mapToObj(index -> "add sim:" + robots.get(index) + " as " + (index + 1))
                .toList();
    }

    /** Reads the address of a port of this computer. */
    static InetSocketAddress address(String option, String text, String example) {
        int colon = text.lastIndexOf(':');
        String port = text.substring(colon + 1);
        if (colon <= 0 || !port.matches("\\d{1,5}") || Integer.parseInt(port) > 65_535) {
            throw new UsageException(option + " " + text + ": not an address; it looks like " + example
                    + " with a port from 0 to 65535");
        }
        return new InetSocketAddress(text.substring(0, colon), Integer.parseInt(port));
    }
}
