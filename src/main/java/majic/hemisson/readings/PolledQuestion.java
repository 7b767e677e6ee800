package majic.hemisson.readings;

import majic.hemisson.line.Question;
import org.jspecify.annotations.Nullable;

/** Something that is looked at again and again, in turn with others. */
@FunctionalInterface
public interface PolledQuestion {
    /**
     * What to ask when it is its turn.
     *
     * @param nowNanos the robot's clock
     * @return null if nothing is to be asked yet
     */
    @Nullable
    Question next(long nowNanos);
}
