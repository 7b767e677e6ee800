package majic.gui;

import java.util.Optional;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.gui.kit.RobotSharing;
import org.jspecify.annotations.Nullable;

/**
 * Pretends to share robots at any broker, except at one that is called {@code nowhere}; one that is called
 * {@code strict} requires the user anna with the password secret.
 */
public final class FakeSharing implements RobotSharing {
    private volatile @Nullable Place place;
    private volatile boolean connected = true;
    private volatile String login = "";

    @Override
    public Place suggested() {
        return new Place("", "desk1", "Anna");
    }

    @Override
    public Optional<Place> now() {
        return Optional.ofNullable(place);
    }

    @Override
    public boolean isConnected() {
        return connected;
    }

    @Override
    public void start(Place wanted) {
        if (wanted.broker().contains("nowhere")) {
            throw new BotException("there is no computer of the name nowhere");
        }
        if (wanted.broker().contains("strict") && !isAnna()) {
            throw new ConnectFailed(
                    ConnectFailed.Reason.WRONG_LOGIN, "the broker refuses the user name or the password");
        }
        place = wanted;
    }

    @Override
    public void useLogin(String broker, String user, char[] password) {
        login = user + ":" + new String(password);
    }

    /** Returns whether the right user name and password were typed. */
    public boolean isAnna() {
        return login.equals("anna:secret");
    }

    @Override
    public void stop() {
        place = null;
    }

    /** Loses the connection with the broker. */
    public void lose() {
        connected = false;
    }
}
