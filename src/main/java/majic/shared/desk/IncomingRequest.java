package majic.shared.desk;

import majic.shared.broker.BrokerMessage;
import majic.shared.message.Request;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.RequestedAction;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * A request that is being carried out, and its answers: perhaps that it is accepted, then exactly one other.
 * Thread-safe.
 */
final class IncomingRequest {
    /** Brokers and clients take packets up to 1 MB. */
    private static final int MOST_PICTURE_BYTES = 1_000_000;

    private final DeskContext desk;
    private final SeenRequests seen;
    private final Request request;
    private final BrokerMessage message;
    private final @Nullable RobotHold held;
    private boolean answered;

    /**
     * @param seen keeps the answers for a second delivery
     * @param held the hold of the sender; null if the robot has to be claimed for what moves it
     */
    IncomingRequest(
            DeskContext desk, SeenRequests seen, Request request, BrokerMessage message, @Nullable RobotHold held) {
        this.desk = desk;
        this.seen = seen;
        this.request = request;
        this.message = message;
        this.held = held;
    }

    Request request() {
        return request;
    }

    /** The hold under which it was received; null if it is not known whether the sender holds the robot. */
    @Nullable
    RobotHold held() {
        return held;
    }

    RequestedAction action() {
        return request.action();
    }

    /** What logs and recordings show. */
    String text() {
        return VisibleText.of(request.action() + " (" + request.sender() + ")");
    }

    /** Answers that another answer follows, unless it has been given already. */
    synchronized void accept() {
        if (!answered) {
            desk.reply(message, RequestReply.of(Outcome.ACCEPTED, ""));
        }
    }

    /** Gives the last answer. */
    synchronized void answer(RequestReply reply) {
        answered = true;
        seen.answered(request, reply);
        desk.reply(message, reply);
    }

    /** Gives the last answer with a picture, a JPEG file. */
    synchronized void answer(byte[] picture) {
        if (picture.length > MOST_PICTURE_BYTES) {
            answer(RequestReply.of(
                    Outcome.FAILED,
                    "the picture has " + picture.length + " bytes; at most " + MOST_PICTURE_BYTES + " can be sent"));
            return;
        }
        answered = true;
        seen.answered(request, RequestReply.done(""));
        if (desk.isAnswerable(message)) {
            desk.publish(message.answer(picture, "image/jpeg"));
        }
    }
}
