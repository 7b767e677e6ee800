package majic;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingUtilities;
import majic.gui.MajicFrame;
import majic.panel.PlotHost;
import majic.program.Program;
import majic.program.UserFolder;
import majic.script.MajicParser;
import majic.simulation.SimulatedLab;
import majicsim.LabOptions;
import majicsim.LabPorts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Measures how long the event thread of a window with twenty simulated robots lets a task wait, without and with four
 * plots of five curves each: {@code mvn -q test -Dtest=PlotLoad}, on a quiet machine with a display. Compare the figures
 * of one run; those of a busy machine say nothing.
 */
class PlotLoad {
    private static final LabOptions TEN_ROBOTS =
            LabOptions.standard().withPorts(LabPorts.FREE).withPioneers(8);
    private static final int PLOTS = 4;
    private static final List<String> CURVES = List.of("x", "y", "heading", "speed", "distanceLeft");
    private static final int PROBES = 2000;
    private static final long PROBE_MS = 10;

    @Test
    @Timeout(300)
    void printsTheDelaysOfTheEventThread(@TempDir Path home) throws Exception {
        try (SimulatedLab other = SimulatedLab.scaled(TEN_ROBOTS, 1);
                Program program = new Program(new UserFolder(home), SimulatedLab.scaled(TEN_ROBOTS, 1), true)) {
            MajicParser parser = new MajicParser(program.session(), true);
            MajicFrame frame = PictureWindow.open(program, parser);
            PictureWindow.add(program, parser, program.lab().robots());
            for (String robot : other.robots()) {
                parser.parseText("add " + other.address(robot).orElseThrow());
            }
            PictureWindow.awaitWindow(() -> program.team().members().size() == 20);
            parser.parseText("pioneer turn 7200");
            measure("warming up");
            measure("20 robots, no plot");
            for (int robot = 1; robot <= PLOTS; robot++) {
                PlotHost host = (PlotHost) SwingUtilities.getAncestorOfClass(
                        PlotHost.class, PictureWindow.find(frame, "pose" + (robot + 1)));
                SwingUtilities.invokeAndWait(() -> host.plot(CURVES, false));
            }
            measure("20 robots, " + PLOTS + " plots begin");
            measure("20 robots, " + PLOTS + " plots");
            SwingUtilities.invokeAndWait(frame::dispose);
        }
    }

    /** Prints the delays of tasks given to the event thread every ten milliseconds. */
    private static void measure(String state) throws InterruptedException {
        List<Double> delays = Collections.synchronizedList(new ArrayList<>());
        CountDownLatch answered = new CountDownLatch(PROBES);
        for (int probe = 0; probe < PROBES; probe++) {
            long givenNanos = System.nanoTime();
            SwingUtilities.invokeLater(() -> {
                delays.add((System.nanoTime() - givenNanos) / 1e6);
                answered.countDown();
            });
            TimeUnit.MILLISECONDS.sleep(PROBE_MS);
        }
        answered.await();
        double[] sorted = delays.stream().mapToDouble(Double::doubleValue).toArray();
        Arrays.sort(sorted);
        System.out.printf(
                Locale.ROOT,
                "%-28s median %5.1f ms, 99 of 100 below %5.1f ms, longest %5.1f ms%n",
                state,
                sorted[sorted.length / 2],
                sorted[sorted.length * 99 / 100],
                sorted[sorted.length - 1]);
    }
}
