package majic.gui.acts;

import java.util.List;
import java.util.Map;
import majic.bot.Value;
import majic.script.ActOffer;

/**
 * An act with the values for its arguments. Immutable.
 *
 * @param offer the act
 * @param values by the names of the arguments
 */
record ChosenAct(ActOffer offer, Map<String, Value> values) {
    ChosenAct {
        values = Map.copyOf(values);
    }

    /**
     * Returns the line that loads it.
     *
     * @param me the number of the robot it is loaded onto
     * @param others the numbers of the further robots, in the order of the roles
     */
    String line(int me, List<Integer> others) {
        return offer.line(me, values, others);
    }
}
