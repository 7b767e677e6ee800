package majic.figures;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.ConnectOptions;
import majic.shared.desk.DeskOptions;
import majic.shared.desk.DeskSharing;
import majic.team.Member;
import majic.team.Team;
import majic.time.TimeSource;

/** Desks in this program that share robots over one broker: each has its own team and its own connection. */
final class SharedDesks implements AutoCloseable {
    private static final int CONNECTING_AT_ONCE = 32;
    private static final BotEnvironment ENVIRONMENT = BotEnvironment.plain();

    private final BrokerAddress broker;
    private final List<Team> teams = new ArrayList<>();
    private final List<DeskSharing> sharings = new ArrayList<>();

    private SharedDesks(BrokerAddress broker) {
        this.broker = broker;
    }

    /** Connects the robots, gives them to the desks in turn, and shares them. */
    static SharedDesks share(BrokerAddress broker, int desks, List<MajicBot> robots)
            throws InterruptedException, ExecutionException {
        SharedDesks shared = new SharedDesks(broker);
        for (int desk = 0; desk < desks; desk++) {
            shared.teams.add(new Team(TimeSource.system(), Team.MOST_BOTS));
        }
        inParallel(robots.size(), robot -> shared.add(robot, robots.get(robot)));
        for (int desk = 0; desk < desks; desk++) {
            shared.share(desk);
        }
        return shared;
    }

    /** Does something for each number, several at the same time. */
    private static void inParallel(int count, java.util.function.IntConsumer work)
            throws InterruptedException, ExecutionException {
        ExecutorService pool = Executors.newFixedThreadPool(CONNECTING_AT_ONCE);
        List<Future<?>> running = new ArrayList<>();
        for (int number = 0; number < count; number++) {
            int one = number;
            running.add(pool.submit(() -> work.accept(one)));
        }
        for (Future<?> one : running) {
            one.get();
        }
        pool.shutdown();
    }

    private Member add(int robot, MajicBot bot) {
        bot.connect();
        return teams.get(robot % teams.size()).add(bot, OptionalInt.of(robot / teams.size() + 1));
    }

    private void share(int desk) {
        DeskOptions options = new DeskOptions(broker.site(), name(desk), "", "MAJIC figures", Set.of(), false);
        DeskSharing sharing = new DeskSharing(
                teams.get(desk),
                options,
                (client, will) -> BrokerConnection.open(
                        broker, ConnectOptions.of(client, ENVIRONMENT).withWill(will)));
        sharing.start();
        sharings.add(sharing);
    }

    private static String name(int desk) {
        return "desk" + (desk + 1);
    }

    /** Returns the address of a shared robot, of each desk in turn. */
    String address(int robot) {
        return broker + "/" + name(robot % teams.size()) + "/" + (robot / teams.size() + 1);
    }

    List<Team> teams() {
        return teams;
    }

    @Override
    public void close() {
        sharings.forEach(DeskSharing::close);
        teams.forEach(Team::close);
    }
}
