package majic.ros.parameters;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;
import majic.bot.MotionFailed;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.Motion;
import majic.ros.bridge.ServiceFailed;
import majic.ros.readings.RosClient;
import majic.ros.readings.RosClient.CallChannel;
import majic.text.Suggestion;
import majic.time.Signal;

/**
 * Calls a service of the robot, for functions without a parameter. A service may move the robot, so it needs the robot
 * to be free. A stop ends the wait for the answer and sends zero velocities; what the service does by itself is not
 * known here.
 */
final class CallCommand {
    private static final double CALL_S = 10;
    private static final double ASK_S = 5;

    private final RosAccess access;
    private final Signal changes;

    /**
     * Creates the command.
     *
     * @param changes the signal that all threads waiting for the robot wait on
     */
    CallCommand(RosAccess access, Signal changes) {
        this.access = access;
        this.changes = changes;
    }

    DriverCommand command() {
        return new DriverCommand(
                        "call",
                        List.of(Parameter.text("service", "its name, as reset or \"/robot1/set_pen\"")),
                        List.of(Parameter.text("arguments", "in quotes: \"x=1 name=bob\" or \"{x: 1, name: 'bob'}\"")),
                        true,
                        "calls a service of the robot and shows what it answers within 10 s",
                        this::call)
                .asRaw();
    }

    private String call(List<Value> typed, Motion motion) {
        ObjectNode arguments = ServiceArguments.parse(
                typed.subList(1, typed.size()).stream().map(Value::toString).toList());
        RosClient connection = access.open().connection();
        String service = find(connection, typed.get(0).toString());
        try (CallChannel channel = connection.openCall(changes::raise)) {
            motion.send(() -> channel.send(service, arguments));
            motion.await(channel::isDone, CALL_S);
            return channel.values()
                    .map(CallCommand::answer)
                    .orElseThrow(
                            () -> new MotionFailed(service + " did not answer within " + Math.round(CALL_S) + " s"));
        } catch (ServiceFailed e) {
            throw new MotionFailed(String.valueOf(e.getMessage()));
        }
    }

    /** Services answer with the fields success and message by custom (std_srvs). */
    private static String answer(JsonNode values) {
        if (values.path("success").isBoolean() && !values.path("success").booleanValue()) {
            throw new MotionFailed(
                    "the service failed: " + values.path("message").asText("without a reason"));
        }
        return values.isEmpty() ? "done, without an answer" : MessageFields.listed(values);
    }

    /** A name without slash in front is looked up in the namespace of the robot, then without. */
    private static String find(RosClient connection, String name) {
        List<String> names = new ArrayList<>();
        if (!name.startsWith("/")) {
            names.add(connection.namespace() + "/" + name);
        }
        names.add(name.startsWith("/") ? name : "/" + name);
        for (String each : names) {
            if (!type(connection, each).isEmpty()) {
                return each;
            }
        }
        throw new MotionFailed(name + ": the robot has no such service" + near(connection, name));
    }

    private static String type(RosClient connection, String service) {
        try {
            return connection
                    .ask("service_type", JsonNodeFactory.instance.objectNode().put("service", service), ASK_S)
                    .path("type")
                    .asText("");
        } catch (ServiceFailed e) {
            if (e.isAnswered()) {
                return "";
            }
            throw e;
        }
    }

    private static String near(RosClient connection, String name) {
        try {
            JsonNode listed = connection
                    .ask("services", JsonNodeFactory.instance.objectNode(), ASK_S)
                    .path("services");
            List<String> all = new ArrayList<>();
            listed.forEach(service -> all.add(service.asText()));
            String suggestion = Suggestion.didYouMean(name.startsWith("/") ? name : "/" + name, all);
            String word = name.substring(name.lastIndexOf('/') + 1);
            List<String> similar = all.stream()
                    .filter(service -> service.contains(word))
                    .limit(5)
                    .toList();
            return !suggestion.isEmpty() || similar.isEmpty()
                    ? suggestion
                    : "; near ones are " + String.join(", ", similar);
        } catch (BotException e) {
            return "";
        }
    }
}
