package majicsim.ros.bridge;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import majicsim.ros.graph.ActionServer;
import majicsim.ros.graph.GoalListener;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.message.JsonForm;
import majicsim.ros.message.MessageInput;
import majicsim.ros.message.MessageMismatch;
import majicsim.ros.message.MessageOutput;

/** send_action_goal and cancel_action_goal of one client; ROS 2 alone (sheet 6). */
final class ActionOperations {
    private static final String ACTION = "action";

    private final Peer peer;
    private final RosNetwork network;
    private final MessageInput input;
    private final MessageOutput output;
    private final Goals goals;

    ActionOperations(Peer peer, RosNetwork network, MessageInput input, Goals goals) {
        this.peer = peer;
        this.network = network;
        this.input = input;
        this.output = new MessageOutput(network.types());
        this.goals = goals;
    }

    /** A missing server never answers, so the connection stays held up. */
    void send(JsonNode message) throws MessageMismatch {
        String name = Fields.text(message, ACTION);
        String typeName = Fields.text(message, "action_type");
        ActionServer server = network.actions().get(network.absolute(name));
        peer.hold(true);
        if (server == null || !server.typeName().equals(typeName)) {
            return;
        }
        Goal goal =
                new Goal(server, message.path("id"), message.path("feedback").asBoolean());
        try {
            JsonNode args = message.path("args");
            ObjectNode request = input.checked(
                    server.goalType(), args.isArray() ? server.goalType().named(args) : args);
            goals.add(goal.key(), server, goal);
            server.start(request, goal);
        } catch (MessageMismatch e) {
            goal.fail(e.getMessage());
        }
    }

    void cancel(JsonNode message) throws MessageMismatch {
        Fields.text(message, ACTION);
        goals.cancel(Fields.id(message));
    }

    /** Sends the progress and the result of one goal, which goes on if the client disconnects. */
    private final class Goal implements GoalListener {
        private final ActionServer server;
        private final JsonNode id;
        private final boolean wantsFeedback;

        Goal(ActionServer server, JsonNode id, boolean wantsFeedback) {
            this.server = server;
            this.id = id;
            this.wantsFeedback = wantsFeedback;
        }

        String key() {
            return id.asText("");
        }

        @Override
        public void progress(ObjectNode feedback) {
            if (wantsFeedback) {
                peer.send(id, to -> {
                    begin(to, "action_feedback", values -> output.write(values, server.feedbackType(), feedback));
                    end(to);
                });
            }
        }

        @Override
        public void ended(int status, ObjectNode result) {
            goals.remove(key());
            sendResult(values -> output.write(values, server.resultType(), result), status, true);
        }

        void fail(String reason) {
            sendResult(values -> values.writeString(reason), 0, false);
        }

        private void sendResult(JsonForm.Content values, int status, boolean succeeded) {
            peer.send(id, to -> {
                begin(to, "action_result", values);
                to.writeNumberField("status", status);
                to.writeBooleanField("result", succeeded);
                end(to);
            });
            peer.hold(false);
        }

        private void begin(JsonGenerator to, String operation, JsonForm.Content values) throws IOException {
            to.writeStartObject();
            to.writeStringField("op", operation);
            to.writeStringField(ACTION, server.name());
            to.writeFieldName("values");
            values.write(to);
        }

        private void end(JsonGenerator to) throws IOException {
            JsonObjects.writeId(to, id);
            to.writeEndObject();
        }
    }
}
