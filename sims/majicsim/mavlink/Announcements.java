package majicsim.mavlink;

import java.util.ArrayList;
import java.util.List;
import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;

/** What the vehicle sends to all ground stations without being asked, in order: texts and events. */
final class Announcements {
    static final int CRITICAL = 2;
    static final int WARNING = 4;
    static final int NOTICE = 5;
    static final int INFO = 6;

    private static final int CHUNK = 50;

    private final List<Message> waiting = new ArrayList<>();
    private int longTexts;

    /** Sends a text; one that is longer than a message holds is sent in pieces with a common id (sheet 6). */
    void say(int severity, String text) {
        if (text.length() <= CHUNK) {
            post(piece(severity, text));
            return;
        }
        longTexts++;
        int pieces = text.length() / CHUNK + 1;
        for (int i = 0; i < pieces; i++) {
            String part = text.substring(i * CHUNK, Math.min(text.length(), (i + 1) * CHUNK));
            post(piece(severity, part).with("id", longTexts).with("chunk_seq", i));
        }
    }

    private static Message piece(int severity, String text) {
        return new Message(MessageType.STATUSTEXT).with("severity", severity).with("text", text);
    }

    void post(Message message) {
        waiting.add(message);
    }

    /** Returns and forgets what was not sent yet. */
    List<Message> drain() {
        List<Message> drained = List.copyOf(waiting);
        waiting.clear();
        return drained;
    }
}
