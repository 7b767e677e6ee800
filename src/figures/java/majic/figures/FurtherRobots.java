package majic.figures;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * What a further robot of a team costs while it reports. Teams of different sizes are connected in turns, each in a
 * program of its own: on the computer of a user, the simulators or nothing at all runs beside a team, and programs that
 * run at the same time take each other's code and data out of the caches, which makes small teams look expensive. Each
 * team has several turns, spread over the whole measurement, because the speed of a computer may change by a quarter
 * from minute to minute. A program takes some processor time however few robots it has, so the cost is the difference
 * from the next smaller team, divided by the number of further robots.
 */
final class FurtherRobots {
    /** Small teams have longer turns: the system counts their little processor time in steps of 10 ms. */
    private static final List<Turns> SIZES =
            List.of(new Turns(1, 30), new Turns(10, 30), new Turns(100, 15), new Turns(500, 15));

    private static final int ROUNDS = 4;

    /**
     * Until the team of 1 runs compiled code: a method is compiled after 200 calls, and its timer wakes 200 times a
     * minute.
     */
    private static final int WARM_UP_S = 60;

    private static final int SETTLING_S = 4;

    /** The cost is compared from this size on; the first robots of a program may cost more. */
    private static final int FIRST_COMPARED = 10;

    private static final double MOST_DIFFERENCE_PERCENT = 20;

    private final List<Team> teams = new ArrayList<>();

    /** The size of a team and the measured part of each of its turns. */
    private record Turns(int robots, int seconds) {}

    private FurtherRobots() {}

    /** Returns a line for each size and one for the comparison. */
    static List<String> measure(ChildProgram programs) throws IOException, InterruptedException {
        FurtherRobots further = new FurtherRobots();
        try {
            for (Turns turns : SIZES) {
                further.teams.add(new Team(turns, programs));
            }
            further.warmUp();
            for (int round = 0; round < ROUNDS; round++) {
                for (Team team : further.teams) {
                    team.takeTurn();
                }
            }
            return further.lines();
        } finally {
            further.teams.forEach(Team::close);
        }
    }

    /** At the same time, since nothing is measured. */
    private void warmUp() throws IOException, InterruptedException {
        for (Team team : teams) {
            team.program.connect();
        }
        Thread.sleep(WARM_UP_S * 1000);
        for (Team team : teams) {
            team.program.disconnect();
        }
    }

    private List<String> lines() {
        List<String> lines = new ArrayList<>();
        double least = Double.MAX_VALUE;
        double most = 0;
        for (int i = 1; i < teams.size(); i++) {
            Team team = teams.get(i);
            Team smaller = teams.get(i - 1);
            double further = (team.percent() - smaller.percent()) / (team.robots() - smaller.robots());
            if (smaller.robots() >= FIRST_COMPARED) {
                least = Math.min(least, further);
                most = Math.max(most, further);
            }
            lines.add(String.format(
                    Locale.ROOT,
                    "%3d Pioneers %6.2f %%, each beyond %3d %.4f %%",
                    team.robots(),
                    team.percent(),
                    smaller.robots(),
                    further));
        }
        lines.add(String.format(
                Locale.ROOT,
                "from %d robots on, the largest of these is %.0f %% above the smallest (at most %.0f %%)",
                FIRST_COMPARED,
                100 * (most / least - 1),
                MOST_DIFFERENCE_PERCENT));
        return lines;
    }

    /** A team with its lab, and what it has used in its turns. Its program waits while it has no turn. */
    private static final class Team implements AutoCloseable {
        private final Turns turns;
        private final ChildProgram.Lab lab;
        private final ChildProgram.Reporting program;
        private Duration used = Duration.ZERO;
        private long measuredNanos;

        Team(Turns turns, ChildProgram programs) throws IOException {
            this.turns = turns;
            this.lab = programs.usualLab(turns.robots);
            this.program = programs.reporting(lab.pioneers());
        }

        int robots() {
            return turns.robots;
        }

        /** The processor time of its turns, percent of one core. */
        double percent() {
            return 100.0 * used.toNanos() / measuredNanos;
        }

        void takeTurn() throws IOException, InterruptedException {
            program.connect();
            Thread.sleep(SETTLING_S * 1000);
            long began = System.nanoTime();
            Duration before = program.processorTime();
            Thread.sleep(turns.seconds * 1000);
            used = used.plus(program.processorTime().minus(before));
            measuredNanos += System.nanoTime() - began;
            program.disconnect();
        }

        @Override
        public void close() {
            program.close();
            lab.close();
        }
    }
}
