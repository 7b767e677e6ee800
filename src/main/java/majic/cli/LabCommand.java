package majic.cli;

import java.io.IOException;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import majic.program.Version;
import majic.simulation.SimulatedLab;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParentCommand;

/** {@code majic lab}: runs the simulators alone, for any client. */
@Command(
        name = "lab",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        sortOptions = false,
        description = "Runs the simulated lab alone and prints where its robots listen, until it is ended by Ctrl-C.")
public final class LabCommand implements Callable<Integer> {
    @ParentCommand
    private @Nullable MajicCommand majic;

    @Override
    public Integer call() throws IOException, InterruptedException {
        LabChoice choice = Objects.requireNonNull(majic).start().labAlone();
        double speed = choice.speed();
        try (SimulatedLab lab = SimulatedLab.scaled(choice.options(), speed)) {
            Map<String, String> addresses = lab.simulators().addresses();
            choice.reportTakenPorts(addresses);
            addresses.forEach((robot, address) -> System.out.println(robot + " " + address));
            System.out.flush();
            lab.onTooSlow(sentence -> System.err.println("majic: " + sentence));
            new CountDownLatch(1).await();
            return 0;
        }
    }
}
