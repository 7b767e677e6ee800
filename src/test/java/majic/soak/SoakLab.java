package majic.soak;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;
import java.util.OptionalInt;
import majic.act.file.ActCatalog;
import majic.act.file.ActTrust;
import majic.bot.MajicBot;
import majic.environment.Settings;
import majic.log.SessionLog;
import majic.program.Plugins;
import majic.script.Session;
import majic.simulation.SimulatedLab;
import majic.team.AutoReconnect;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majic.time.TimeSource.Membership;
import majicsim.LabOptions;

/**
 * A stepped lab with noise, and a team of its robots that connects lost ones again, with a session and its log. The
 * creating thread is registered with the lab's clock.
 */
final class SoakLab implements AutoCloseable {
    static final String ACT_FILE = "Soak.majic";

    private static final int PIONEERS = 3;
    private static final String ACT = "argument times = 1\nrepeat 2\n  me move 20\n  me turn 10\nend\n";

    private final SimulatedLab lab;
    private final Membership membership;
    private final Team team;
    private final SessionLog log;
    private final Session session;
    private final AutoReconnect reconnect;

    /** Opens a lab and connects its robots; the session log and the act are put into a folder. */
    SoakLab(long seed, Path folder) throws IOException {
        lab = SimulatedLab.stepped(
                LabOptions.exactOnFreePorts().withPioneers(PIONEERS).withNoise(seed));
        membership = lab.time().join();
        Settings settings = Settings.inMemory();
        BotFactory factory = new BotFactory(Plugins.in(Path.of("none")).types(), settings);
        factory.useLab(lab);
        team = new Team(lab.time());
        log = SessionLog.in(folder, Clock.systemDefaultZone());
        Files.writeString(folder.resolve(ACT_FILE), ACT);
        session = new Session(team, factory, log, new ActCatalog(folder, new ActTrust(settings)), () -> {});
        reconnect = new AutoReconnect(team, member -> {});
        reconnect.enable(true);
        lab.robots().forEach(this::add);
    }

    private void add(String robot) {
        String address = "sim:" + robot;
        MajicBot bot = session.factory().create(address);
        bot.connect();
        session.joined(team.add(bot, OptionalInt.empty()), address);
    }

    SimulatedLab lab() {
        return lab;
    }

    List<String> robots() {
        return lab.robots();
    }

    Team team() {
        return team;
    }

    /** Returns whether and when a lost robot is connected again by itself, in words. */
    String reconnecting(Member member) {
        return reconnect.status(member).map(AutoReconnect.Status::toString).orElse("no");
    }

    Session session() {
        return session;
    }

    /** The file of the session log; complete after {@link #close()}. */
    Path log() {
        return log.file().orElseThrow();
    }

    @Override
    public void close() {
        reconnect.close();
        team.close();
        session.flush();
        log.close();
        membership.close();
        lab.close();
    }
}
