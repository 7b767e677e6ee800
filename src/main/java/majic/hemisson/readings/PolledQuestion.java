package majic.hemisson.readings;

import majic.hemisson.line.Question;
import org.jspecify.annotations.Nullable;

/** A question that is polled on request, in turn with others. */
@FunctionalInterface
public interface PolledQuestion {
    /**
     * The question to send in this turn.
     *
     * @param nowNanos the robot's clock
     * @return null to skip this turn
     */
    @Nullable
    Question next(long nowNanos);
}
