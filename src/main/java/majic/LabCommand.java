package majic;

import java.io.IOException;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import majicsim.Lab;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code majic lab}: the simulators alone, for any client. */
@Command(
        name = "lab",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Runs the simulated lab alone and prints where its robots listen, until it is ended by Ctrl-C.")
final class LabCommand implements Callable<Integer> {
    @Mixin
    private LabChoice choice = new LabChoice();

    @Override
    public Integer call() throws IOException, InterruptedException {
        double speed = choice.speed();
        try (Lab lab = Lab.open(choice.options())) {
            lab.addresses().forEach((robot, address) -> System.out.println(robot + " " + address));
            System.out.flush();
            lab.run(speed);
            new CountDownLatch(1).await();
            return 0;
        }
    }
}
