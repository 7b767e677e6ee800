package majic.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.HashSet;
import java.util.Set;
import majic.ros.websocket.WebSocketClient;

/** Decodes what a server sends and passes each operation on by its kind. Used by the reader thread. */
final class OperationRouter implements WebSocketClient.Listener {
    private static final Logger LOG = System.getLogger(OperationRouter.class.getName());
    private static final int SHOWN_CHARS = 200;

    private final Routes routes;
    private final Fragments fragments = new Fragments(RosBridge.LONGEST_MESSAGE);
    private final Set<String> noticed = new HashSet<>();

    /** The receivers of the operations. */
    interface Routes {
        void published(String topic, JsonNode message, int bytes);

        void answered(ObjectNode response);

        void feedback(ObjectNode feedback);

        void result(ObjectNode result);

        /** Handles a message that was longer than the limit. */
        void leftOut();

        /** Handles a message for the user, the first time that there is a reason for it. */
        void notice(String message);

        void ended(IOException cause);
    }

    OperationRouter(Routes routes) {
        this.routes = routes;
    }

    @Override
    public void text(String text) {
        try {
            route(BridgeCodec.decode(text), text.length());
        } catch (IOException e) {
            unusable(text.substring(0, Math.min(text.length(), SHOWN_CHARS)), e);
        }
    }

    @Override
    public void binary(byte[] bytes) {
        try {
            route(BridgeCodec.decode(bytes), bytes.length);
        } catch (IOException e) {
            unusable(bytes.length + " binary bytes", e);
        }
    }

    private void unusable(String what, IOException reason) {
        LOG.log(Level.DEBUG, () -> "not an operation: " + what, reason);
        noticeOnce("the rosbridge server sends messages that are not JSON objects; they are ignored");
    }

    private void route(ObjectNode operation, int bytes) {
        String kind = operation.path("op").asText();
        switch (kind) {
            case "publish" -> routes.published(operation.path("topic").asText(), operation.path("msg"), bytes);
            case "service_response" -> routes.answered(operation);
            case "action_feedback" -> routes.feedback(operation);
            case "action_result" -> routes.result(operation);
            case "fragment" -> join(operation);
            case "status" -> LOG.log(Level.DEBUG, "status of the server: {0}", operation);
            case "png" ->
                noticeOnce(
                        "the rosbridge server sends messages as PNG pictures, which were not asked for; they are ignored");
            default -> LOG.log(Level.DEBUG, "an operation of an unknown kind: {0}", kind);
        }
    }

    private void join(ObjectNode fragment) {
        String whole = fragments.add(fragment);
        if (whole != null) {
            text(whole);
        }
    }

    @Override
    public void tooLong() {
        routes.leftOut();
        noticeOnce("the rosbridge server sent a message of more than " + (RosBridge.LONGEST_MESSAGE >> 20)
                + " MB, which was left out; such a topic is better throttled or compressed on the robot");
    }

    private void noticeOnce(String message) {
        if (noticed.add(message)) {
            routes.notice(message);
        }
    }

    @Override
    public void ended(IOException cause) {
        routes.ended(cause);
    }
}
