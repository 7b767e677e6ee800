package majic.hemisson.modules;

import java.util.function.Function;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.hemisson.line.Question;
import majic.hemisson.readings.RobotReadings;

/** A setting of a module that the robot accepts but never reports; holds the value sent last. Thread-safe. */
final class UnreportedSetting {
    private volatile Value value = Value.unknown("not set since it was connected");

    /** The command for a value, and the value that results. Immutable. */
    record Order(Question question, Value value) {}

    /**
     * Adds the setting.
     *
     * @param order makes what is sent for a value
     */
    void describe(ParameterTable table, RobotReadings access, Parameter parameter, Function<Value, Order> order) {
        table.add(parameter, () -> value).writes(values -> take(access, order.apply(values.get(0))));
    }

    private void take(RobotReadings access, Order order) {
        access.send(order.question());
        value = order.value();
    }
}
