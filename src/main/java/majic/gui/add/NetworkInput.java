package majic.gui.add;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JTextField;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.gui.kit.MajicDialog;
import majic.text.Texts;

/** Takes host and port of a robot on the network, or of the serial server to which it is connected. */
final class NetworkInput extends AddressInput {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(NetworkInput.class);

    private static final Pattern PLACE = Pattern.compile("(?:tcp:)?//([^/:?\\s]+)(?::(\\d{1,5}))?([/?]\\S*)?");

    private final transient BotType type;
    private final JTextField host = new JTextField(22);
    private final JTextField port = new JTextField(6);

    /** Which of the robots behind host and port; shown only if there may be several. */
    private final JTextField namespace = new JTextField(22);

    NetworkInput(BotType type) {
        this.type = type;
        host.setName("host");
        port.setName("port");
        host.putClientProperty("JTextField.placeholderText", TEXTS.get("host.example"));
        port.setText(usualPort());
        add(MajicDialog.label(TEXTS.get("host"), host));
        add(host, "wrap");
        add(MajicDialog.label(TEXTS.get("port"), port));
        add(port, "grow 0");
        if (type.isOneOfSeveral()) {
            addNamespace();
        }
    }

    private void addNamespace() {
        namespace.setName("namespace");
        namespace.putClientProperty("JTextField.placeholderText", TEXTS.get("namespace.example"));
        add(MajicDialog.label(TEXTS.get("namespace"), namespace), "newline");
        add(namespace);
    }

    @Override
    String address() {
        String start = type.reaches().get(0) == BotType.Reach.TCP ? "://" : ":tcp://";
        return type.name() + start + checkedHost() + ":" + checkedPort() + checkedNamespace();
    }

    @Override
    boolean fill(BotAddress address) {
        Matcher place = PLACE.matcher(address.rest());
        if (!address.scheme().equals(type.name()) || !place.matches()) {
            return false;
        }
        String behind = place.group(3);
        if (behind != null && !type.isOneOfSeveral()) {
            return false;
        }
        namespace.setText(behind == null || behind.equals("/") ? "" : behind);
        host.setText(place.group(1));
        String given = place.group(2);
        port.setText(given == null ? usualPort() : given);
        return true;
    }

    private String usualPort() {
        int usual = type.defaultPort(type.name());
        return usual == 0 ? "" : String.valueOf(usual);
    }

    @Override
    String advice() {
        return type.advice();
    }

    private String checkedHost() {
        String text = host.getText().strip();
        if (text.isEmpty()) {
            throw new BotException(TEXTS.get("host.missing"));
        }
        if (text.contains("/") || text.chars().anyMatch(Character::isWhitespace)) {
            throw new BotException(TEXTS.get("host.wrong", text));
        }
        return text;
    }

    /** Returns what follows the port: empty, or with a slash or a question mark at its beginning. */
    private String checkedNamespace() {
        String text = namespace.getText().strip();
        if (text.chars().anyMatch(Character::isWhitespace)) {
            throw new BotException(TEXTS.get("namespace.wrong", text));
        }
        return text.isEmpty() || text.startsWith("/") || text.startsWith("?") ? text : "/" + text;
    }

    private int checkedPort() {
        String text = port.getText().strip();
        if (text.matches("\\d{1,5}")) {
            int number = Integer.parseInt(text);
            if (number >= 1 && number <= 65_535) {
                return number;
            }
        }
        throw new BotException(TEXTS.get("port.wrong", text));
    }
}
