package majic.figures;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import majic.bot.MajicBot;
import majic.environment.Settings;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majic.time.TimeSource;

/**
 * A program that commands a team through {@link Team} and nothing else of MAJIC. Measures what it uses while all robots report
 * and nothing is commanded, then the time from a command to its bytes on the link.
 */
final class TeamLoad {
    private static final int CONNECTING_AT_ONCE = 32;
    private static final int SETTLING_S = 15;
    private static final int MEASURED_S = 20;
    private static final int FEWEST_PER_SECOND = 50;
    private static final int PER_ROBOT_AND_SECOND = 5;

    private final ProcessSample.Pauses pauses = new ProcessSample.Pauses();
    private final Team team;
    private final BotFactory factory =
            new BotFactory(BotFactory.types(TeamLoad.class.getClassLoader()), Settings.inMemory());

    private TeamLoad(int robots) {
        this.team = new Team(TimeSource.system(), robots);
    }

    /** Connects to the robots of the addresses, prints one line of figures and ends. */
    public static void main(String[] addresses) {
        Measurement.run(() -> {
            TeamLoad load = new TeamLoad(addresses.length);
            try {
                return List.of(load.measure(List.of(addresses)));
            } finally {
                load.team.close();
            }
        });
    }

    /** Returns the figures in the order of the columns of {@link LoadTable}. */
    private String measure(List<String> addresses) throws InterruptedException, ExecutionException {
        loadClasses(addresses.get(0));
        team.addListener(new FirstFailure());
        ProcessSample.heapBytes();
        Thread.sleep(1000);
        long heapBefore = ProcessSample.heapBytes();
        int threadsBefore = ProcessSample.now().threads();
        connect(addresses);
        Thread.sleep(SETTLING_S * 1000);
        pauses.reset();
        double percent = percentWhileReporting();
        int threads = ProcessSample.now().threads() - threadsBefore;
        double[] commands = commands(percent);
        double heapKb = (ProcessSample.heapBytes() - heapBefore) / 1024.0;
        DoubleStream program = DoubleStream.of(addresses.size(), percent, heapKb, threads);
        return DoubleStream.concat(program, DoubleStream.of(commands))
                .mapToObj(String::valueOf)
                .collect(Collectors.joining(" "));
    }

    private static double percentWhileReporting() throws InterruptedException {
        ProcessSample began = ProcessSample.now();
        Thread.sleep(MEASURED_S * 1000);
        return ProcessSample.now().percentSince(began);
    }

    /** Sends commands once to warm up, then again. */
    private double[] commands(double percentWithout) throws InterruptedException {
        int perSecond = Math.max(
                FEWEST_PER_SECOND, PER_ROBOT_AND_SECOND * team.members().size());
        new CommandTimes(team.members(), perSecond * SETTLING_S).run(perSecond);
        ProcessSample before = ProcessSample.now();
        CommandTimes times = new CommandTimes(team.members(), perSecond * MEASURED_S);
        times.run(perSecond);
        double percent = ProcessSample.now().percentSince(before);
        return new double[] {
            times.withinMs(0.5),
            times.withinMs(0.99),
            times.withinMs(0.999),
            times.perSecond(),
            (percent - percentWithout) / 100 * 1e6 / times.perSecond(),
            times.notSent(),
            pauses.count(),
            pauses.longestMs()
        };
    }

    private void connect(List<String> addresses) throws InterruptedException, ExecutionException {
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

    /** Connects once to a robot, so that the classes of a driver do not count as the memory of a robot. */
    private void loadClasses(String address) {
        MajicBot bot = factory.create(address);
        bot.connect();
        bot.close();
    }

    private Member add(String address) {
        MajicBot bot = factory.create(address);
        bot.connect();
        return team.add(bot, OptionalInt.empty());
    }
}
