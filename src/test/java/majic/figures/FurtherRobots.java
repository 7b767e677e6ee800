package majic.figures;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * What a further robot of a team costs while it reports. Teams of all sizes run at the same time, each in a program of
 * its own, so that all of them meet the same speed of the computer, which may change by a quarter from minute to
 * minute. A program takes some processor time however few robots it has, so the cost is the difference from the next
 * smaller team, divided by the number of further robots; of small teams there are several, because one of them takes
 * too little to be measured.
 */
final class FurtherRobots {
    private static final List<Size> SIZES =
            List.of(new Size(1, 8), new Size(10, 8), new Size(100, 1), new Size(500, 1));
    private static final int SETTLING_S = 30;
    private static final int MEASURED_S = 75;
    private static final double MOST_DIFFERENCE_PERCENT = 20;

    private final ChildProgram programs;
    private final List<ChildProgram.Lab> labs = new ArrayList<>();
    private final List<List<ChildProgram.Reporting>> teams = new ArrayList<>();

    /** Teams of one size, and how many of them there are. */
    private record Size(int robots, int teams) {}

    private FurtherRobots(ChildProgram programs) {
        this.programs = programs;
    }

    /** Returns a line for each size and one for the comparison. */
    static List<String> measure(ChildProgram programs) throws IOException, InterruptedException {
        FurtherRobots further = new FurtherRobots(programs);
        try {
            for (Size size : SIZES) {
                further.start(size);
            }
            Thread.sleep(SETTLING_S * 1000);
            return lines(further.percentOfOneTeam());
        } finally {
            further.teams.forEach(some -> some.forEach(ChildProgram.Reporting::close));
            further.labs.forEach(ChildProgram.Lab::close);
        }
    }

    /** All teams of one size share a lab. */
    private void start(Size size) throws IOException {
        ChildProgram.Lab lab = programs.usualLab(size.robots * size.teams);
        labs.add(lab);
        List<ChildProgram.Reporting> some = new ArrayList<>();
        teams.add(some);
        for (int i = 0; i < size.teams; i++) {
            some.add(programs.reporting(lab.pioneers().subList(i * size.robots, (i + 1) * size.robots)));
        }
    }

    /** Returns the processor time of a team of each size, percent of one core. */
    private double[] percentOfOneTeam() throws InterruptedException {
        double[] seconds = new double[SIZES.size()];
        addSeconds(seconds, -1);
        long began = System.nanoTime();
        Thread.sleep(MEASURED_S * 1000);
        addSeconds(seconds, 1);
        double passed = (System.nanoTime() - began) / 1e9;
        for (int i = 0; i < seconds.length; i++) {
            seconds[i] *= 100 / passed / SIZES.get(i).teams;
        }
        return seconds;
    }

    private void addSeconds(double[] seconds, int sign) {
        for (int i = 0; i < seconds.length; i++) {
            for (ChildProgram.Reporting team : teams.get(i)) {
                seconds[i] += sign * team.processorTime().toNanos() / 1e9;
            }
        }
    }

    private static List<String> lines(double[] percent) {
        List<String> lines = new ArrayList<>();
        double least = Double.MAX_VALUE;
        double most = 0;
        for (int i = 1; i < percent.length; i++) {
            int robots = SIZES.get(i).robots;
            int fewer = SIZES.get(i - 1).robots;
            double further = (percent[i] - percent[i - 1]) / (robots - fewer);
            least = Math.min(least, further);
            most = Math.max(most, further);
            lines.add(String.format(
                    Locale.ROOT, "%3d Pioneers %6.2f %%, each beyond %3d %.4f %%", robots, percent[i], fewer, further));
        }
        lines.add(String.format(
                Locale.ROOT,
                "the largest of these is %.0f %% above the smallest (at most %.0f %%)",
                100 * (most / least - 1),
                MOST_DIFFERENCE_PERCENT));
        return lines;
    }
}
