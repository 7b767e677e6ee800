package majic.script.run;

import java.util.Optional;
import java.util.Random;
import majic.lab.LabAccess;
import majic.team.BotFactory;
import org.jspecify.annotations.Nullable;

/** The random numbers of all scripts of a session: in the simulated lab the same ones in each run. Thread-safe. */
public final class RandomNumbers {
    private final BotFactory factory;
    private Random random = new Random();
    private @Nullable LabAccess lab;

    /** Looks for a lab each time, since one may be started later. */
    public RandomNumbers(BotFactory factory) {
        this.factory = factory;
    }

    /** The next number, from 0 to less than 1. */
    synchronized double next() {
        Optional<LabAccess> now = factory.lab();
        if (now.isPresent() && now.get() != lab) {
            lab = now.get();
            random = new Random(lab.seed());
        }
        return random.nextDouble();
    }
}
