package majic.shared;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import majic.bot.BotCommand;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.ParameterTable;
import majic.shared.message.Description;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestedAction;
import majic.shared.message.RobotState;
import majic.shared.message.ValueJson;
import majic.time.WaitPolicy;

/** The parameters and commands of a shared robot, made from its description. Thread-safe. */
final class DescribedParameters {
    /** The driver reads it from the profile. */
    private static final String BODY = "body";

    private final RemoteMotions motions;
    private final Supplier<Map<String, JsonNode>> values;
    private final BooleanSupplier isConnected;

    /**
     * Reads and sets the parameters of one robot.
     *
     * @param motions commands it
     * @param values the newest values
     * @param isConnected whether they are still reported
     */
    DescribedParameters(RemoteMotions motions, Supplier<Map<String, JsonNode>> values, BooleanSupplier isConnected) {
        this.motions = motions;
        this.values = values;
        this.isConnected = isConnected;
    }

    /** Replaces the parameters of an earlier description. */
    void describe(ParameterTable table, Description description) {
        table.renew(fresh -> description.parameters().forEach(parameter -> {
            if (!isOfDriver(parameter.name())) {
                add(fresh, parameter);
            }
        }));
    }

    /** The values of the movement are read in the frame in which this program has placed the robot. */
    private static boolean isOfDriver(String parameter) {
        return RobotState.NOT_IN_VALUES.contains(parameter) || parameter.equals(BODY);
    }

    private void add(ParameterTable table, Parameter parameter) {
        ParameterTable.Entry entry =
                parameter.readable() ? table.add(parameter, () -> read(parameter)) : table.addWriteOnly(parameter);
        if (parameter.moves()) {
            entry.moves((given, motion) -> motions.perform(motion, until -> set(parameter, given)));
        } else if (parameter.writable()) {
            entry.writes(given -> motions.ask(set(parameter, given)));
        }
    }

    private static RequestedAction set(Parameter parameter, List<Value> given) {
        return new RequestedAction.Set(parameter.name(), given);
    }

    /** The state has what the robot reports by itself; for all else its desk has to ask the robot. */
    private Value read(Parameter parameter) {
        if (!isConnected.getAsBoolean()) {
            return Value.unknown("not connected");
        }
        JsonNode json = values.get().get(parameter.name());
        Value known =
                json == null ? Value.unknown("its desk has not reported it yet") : ValueJson.read(json, parameter);
        if (!(known instanceof Value.Unknown) || !WaitPolicy.isAllowed()) {
            return known;
        }
        RequestReply reply = motions.ask(new RequestedAction.Get(parameter.name()));
        JsonNode asked = reply.value();
        return asked == null ? known : ValueJson.read(asked, parameter);
    }

    /** Returns a command of the description that has the desk run it. */
    DriverCommand command(BotCommand described) {
        return new DriverCommand(described, (arguments, motion) -> {
            RequestedAction run = new RequestedAction.Run(described.name(), arguments);
            RequestReply reply = described.moves() ? motions.perform(motion, until -> run) : motions.ask(run);
            return reply == null ? "" : reply.text();
        });
    }
}
