package majic.figures;

import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import majic.team.Team;

/**
 * A program that commands a team through {@link Team} and nothing else of MAJIC. Measures what it uses while all robots
 * report and nothing is commanded, then the time from a command to its bytes on the link.
 */
final class TeamLoad {
    private static final int SETTLING_S = 15;
    private static final int MEASURED_S = 20;
    private static final int FEWEST_PER_SECOND = 50;
    private static final int PER_ROBOT_AND_SECOND = 5;

    private final ProcessSample.Pauses pauses = new ProcessSample.Pauses();
    private final ConnectedTeam robots;
    private final Team team;

    private TeamLoad(ConnectedTeam robots) {
        this.robots = robots;
        this.team = robots.team();
    }

    /** Connects to the robots of the addresses, prints one line of figures and ends. */
    public static void main(String[] addresses) {
        Measurement.run(() -> {
            try (ConnectedTeam robots = new ConnectedTeam(addresses.length)) {
                return List.of(new TeamLoad(robots).measure(List.of(addresses)));
            }
        });
    }

    /** Returns the figures in the order of the columns of {@link LoadTable}. */
    private String measure(List<String> addresses) throws InterruptedException, ExecutionException {
        robots.loadClasses(addresses.get(0));
        team.addListener(new FirstFailure());
        ProcessSample.heapBytes();
        Thread.sleep(1000);
        long heapBefore = ProcessSample.heapBytes();
        int threadsBefore = ProcessSample.now().threads();
        robots.connect(addresses);
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
}
