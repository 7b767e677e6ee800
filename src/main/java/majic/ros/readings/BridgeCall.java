package majic.ros.readings;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import majic.ros.bridge.RosBridge;
import majic.ros.bridge.ServiceReply;
import org.jspecify.annotations.Nullable;

/** One call of a service over a bridge. Thread-safe. */
final class BridgeCall implements RosClient.CallChannel {
    private final RosBridge bridge;
    private final Runnable end;
    private final Runnable changed;
    private volatile @Nullable ServiceReply reply;

    /**
     * Creates the channel of a call.
     *
     * @param end ends what was opened for this call only
     * @param changed called when the service has answered
     */
    BridgeCall(RosBridge bridge, Runnable end, Runnable changed) {
        this.bridge = bridge;
        this.end = end;
        this.changed = changed;
    }

    @Override
    public void send(String service, JsonNode arguments) {
        reply = bridge.begin(service, arguments, changed);
    }

    @Override
    public boolean isDone() {
        ServiceReply sent = reply;
        return sent != null && sent.isDone();
    }

    @Override
    public Optional<JsonNode> values() {
        ServiceReply sent = reply;
        return sent == null ? Optional.empty() : sent.values();
    }

    @Override
    public void close() {
        ServiceReply sent = reply;
        if (sent != null) {
            sent.close();
        }
        end.run();
    }
}
