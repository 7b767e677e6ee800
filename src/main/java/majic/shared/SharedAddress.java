package majic.shared;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.shared.broker.BrokerAddress;
import majic.shared.message.Sender;

/**
 * The address of a shared robot: {@code mqtt://broker:1883/lab/desk2/1}. Immutable.
 *
 * @param broker the broker, with the site
 * @param desk the desk that has the robot
 * @param robot its number there; at least 1
 */
record SharedAddress(BrokerAddress broker, String desk, int robot) {
    private static final Pattern FORM = Pattern.compile("(.*[^/])/([^/]+)/(\\d{1,9})");

    /** Returns whether an address ends with a slash, and so asks what is there. */
    static boolean isListing(BotAddress address) {
        return address.rest().endsWith("/");
    }

    /**
     * Reads an address.
     *
     * @throws BotException if it is wrong; the message shows a right one
     */
    static SharedAddress parse(BotAddress address) {
        String text = address.toString();
        Matcher form = FORM.matcher(text);
        if (!form.matches() || !Sender.isDesk(form.group(2)) || Integer.parseInt(form.group(3)) < 1) {
            BrokerAddress.parse(text);
            throw new BotException(
                    text + ": not the address of a shared robot; it looks like mqtt://broker/lab/desk2/1,"
                            + " with the desk and the robot's number there; add mqtt://broker/lab/ with a slash at the end lists"
                            + " what is there");
        }
        return new SharedAddress(BrokerAddress.parse(form.group(1)), form.group(2), Integer.parseInt(form.group(3)));
    }

    /** Returns what messages call the robot: {@code robot 1 of desk2}. */
    String title() {
        return "robot " + robot + " of " + desk;
    }

    /** Returns the address as it is typed. */
    @Override
    public String toString() {
        return broker + "/" + desk + "/" + robot;
    }
}
