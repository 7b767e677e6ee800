package majic.hemisson.line;

import java.io.IOException;
import java.util.List;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.LinkLost;
import majic.link.Link;
import majic.link.LinkAddress;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** The session with one robot, and how to open the next. Thread-safe. */
public final class CurrentSession {
    private static final int BAUD = 115_200;
    private static final int OPEN_TIMEOUT_MS = 3000;

    private final LinkAddress address;
    private final TimeSource time;
    private volatile @Nullable HemissonSession session;

    /**
     * Opens nothing yet.
     *
     * @throws BotException if the address is not valid
     */
    public CurrentSession(String address, TimeSource time) {
        this.time = time;
        try {
            this.address = LinkAddress.of(address, 0, BAUD);
        } catch (IllegalArgumentException e) {
            throw new BotException("hemisson:" + e.getMessage(), e);
        }
    }

    /** The names under which settings of the robot are kept, the best first. */
    public List<String> names() {
        return address.names();
    }

    /** Ends the session if there is one, and opens another, whose reader is not yet started. */
    public HemissonSession open(ConversationListener listener) {
        end();
        Link link = address.newLink();
        try {
            link.open(OPEN_TIMEOUT_MS);
        } catch (IOException e) {
            throw ConnectFailed.of(e);
        }
        HemissonSession opened = new HemissonSession(link, time, listener);
        session = opened;
        return opened;
    }

    public void end() {
        HemissonSession open = session;
        session = null;
        if (open != null) {
            open.close();
        }
    }

    /** The session, perhaps one whose link has failed; null if there is none. */
    public @Nullable HemissonSession current() {
        return session;
    }

    /**
     * The conversation with the robot.
     *
     * @throws LinkLost if there is no session
     */
    public Conversation conversation() {
        HemissonSession open = session;
        if (open == null) {
            throw new LinkLost("not connected");
        }
        return open.conversation();
    }

    /** Time since the last answer, seconds; 0 without a connection. */
    public double silentSeconds() {
        HemissonSession open = session;
        return open == null ? 0 : open.conversation().silentSeconds();
    }

    /** How well the line works; {@link LinkQuality#NONE} without a session. */
    public LinkQuality quality() {
        HemissonSession open = session;
        return open == null ? LinkQuality.NONE : open.conversation().quality();
    }
}
