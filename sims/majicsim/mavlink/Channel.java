package majicsim.mavlink;

import java.util.List;
import majicsim.mavlink.message.Frame;
import majicsim.mavlink.message.FrameReader;
import majicsim.mavlink.message.Message;
import majicsim.net.Line;
import org.jspecify.annotations.Nullable;

/**
 * One link to a ground station: frames on its line, the rates of its messages, and the list of parameters under way.
 */
final class Channel {
    private static final int AUTOPILOT = 1;
    private static final int PARAMETERS_A_STEP = 10;

    private final Line line;
    private final int version;
    private final Parameters parameters;
    private final FrameReader reader = new FrameReader();
    private final Streams streams = new Streams();
    private int sequence;
    private int nextParameter = Integer.MAX_VALUE;

    Channel(Line line, int version, Parameters parameters) {
        this.line = line;
        this.version = version;
        this.parameters = parameters;
    }

    boolean isOf(Line other) {
        return line == other;
    }

    Streams streams() {
        return streams;
    }

    /** The frames that are complete with these bytes; a vehicle of version 1 ignores those of version 2. */
    List<Frame> read(byte[] bytes) {
        return reader.feed(bytes).stream()
                .filter(frame -> frame.version() <= version)
                .toList();
    }

    void send(Message message) {
        if (version == 1 && message.type().id() > 255) {
            return;
        }
        int system = (int) parameters.get("SYSID_THISMAV");
        line.send(new Frame(version, sequence, system, AUTOPILOT, message).toBytes());
        sequence = sequence + 1 & 0xFF;
    }

    /** Sends bytes that are no frame. */
    void sendText(byte[] text) {
        line.send(text);
    }

    /** Begins to send all parameters. */
    void listParameters() {
        nextParameter = 0;
    }

    boolean isListing() {
        return nextParameter < parameters.count();
    }

    /** Sends some of the parameters of a list. */
    void step() {
        for (int i = 0; i < PARAMETERS_A_STEP; i++) {
            @Nullable String name = parameters.name(nextParameter);
            if (name == null) {
                return;
            }
            send(parameters.message(name, nextParameter));
            nextParameter++;
        }
    }

    void restart() {
        streams.restart();
        sequence = 0;
        nextParameter = Integer.MAX_VALUE;
    }
}
