package majic.gui.add;

import java.net.InetSocketAddress;
import majic.bot.BotType;
import majic.gui.kit.ProgramServices.SerialPortChoice;
import majic.text.Texts;

/**
 * A place at which there may be a robot.
 *
 * @param address as it is typed
 * @param text for the list: type and place
 */
record FoundRobot(String address, String text) {
    private static final Texts TEXTS = Texts.of(FoundRobot.class);

    static FoundRobot at(InetSocketAddress place, BotType type) {
        String where = place.getAddress().getHostAddress() + ":" + place.getPort();
        String start = type.reaches().get(0) == BotType.Reach.TCP ? "://" : ":tcp://";
        return new FoundRobot(type.name() + start + where, TEXTS.get("found", type.label(), where));
    }

    static FoundRobot sending(String address, String kind, BotType type) {
        return new FoundRobot(address, TEXTS.get("found", type.label() + ", " + kind, address));
    }

    static FoundRobot at(SerialPortChoice port, BotType type) {
        return new FoundRobot(type.name() + ":" + port.name(), TEXTS.get("foundPort", port, type.label()));
    }

    @Override
    public String toString() {
        return text;
    }
}
