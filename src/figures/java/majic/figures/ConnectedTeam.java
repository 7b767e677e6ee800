package majic.figures;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import majic.bot.MajicBot;
import majic.environment.Settings;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majic.time.TimeSource;

/** A {@link Team} in a program that uses nothing else of MAJIC. */
final class ConnectedTeam implements AutoCloseable {
    private static final int CONNECTING_AT_ONCE = 32;

    private final Team team;
    private final BotFactory factory =
            new BotFactory(BotFactory.types(ConnectedTeam.class.getClassLoader()), Settings.inMemory());

    /** A team without robots so far. */
    ConnectedTeam(int robots) {
        this.team = new Team(TimeSource.system(), robots);
    }

    Team team() {
        return team;
    }

    /** Connects once to a robot, so that the classes of a driver do not count as the memory of a robot. */
    void loadClasses(String address) {
        MajicBot bot = factory.create(address);
        bot.connect();
        bot.close();
    }

    /** Connects to the robots of the addresses and adds them. */
    void connect(List<String> addresses) throws InterruptedException, ExecutionException {
        ExecutorService pool = Executors.newFixedThreadPool(CONNECTING_AT_ONCE);
        List<Future<Member>> added = new ArrayList<>();
        for (String address : addresses) {
            added.add(pool.submit(() -> add(address)));
        }
        for (Future<Member> one : added) {
            one.get();
        }
        pool.shutdown();
    }

    @Override
    public void close() {
        team.close();
    }

    private Member add(String address) {
        MajicBot bot = factory.create(address);
        bot.connect();
        return team.add(bot, OptionalInt.empty());
    }
}
