package majic.gui.add;

import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JTextField;
import javax.swing.text.JTextComponent;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.gui.kit.EventThread;
import majic.gui.kit.MajicDialog;
import majic.team.BotFactory;
import majic.text.Texts;

/** Takes the broker, the site and the robot of another desk; lists the robots that are shared at the site. */
final class SiteInput extends AddressInput {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(SiteInput.class);

    private static final Pattern PLACE =
            Pattern.compile("//([^/:\\s]+)(?::(\\d{1,5}))?/(\\S*?)(?:/([^/\\s]+/\\d+))?/?");

    private final transient BotType type;
    private final transient BotFactory factory;
    private transient RefusalListener refusals = (refusal, address, again) -> {};
    private final JTextField host = new JTextField(16);
    private final JTextField port = new JTextField(6);
    private final JCheckBox secure = new JCheckBox(TEXTS.get("site.tls"));
    private final JTextField site = new JTextField(16);
    private final JComboBox<String> robot = new JComboBox<>();
    private final JButton list = new JButton(TEXTS.get("site.list"));

    SiteInput(BotType type, BotFactory factory) {
        this.type = type;
        this.factory = factory;
        host.setName("brokerHost");
        port.setName("brokerPort");
        secure.setName("brokerTls");
        site.setName("site");
        robot.setName("siteRobot");
        list.setName("listRobots");
        robot.setEditable(true);
        port.setText(usualPort(false));
        site.putClientProperty("JTextField.placeholderText", TEXTS.get("site.example"));
        secure.addActionListener(event -> changePort());
        list.addActionListener(event -> listRobots());
        add(MajicDialog.label(TEXTS.get("site.broker"), host));
        add(host, "wrap");
        add(MajicDialog.label(TEXTS.get("port"), port));
        add(port, "split 2, grow 0");
        add(secure, "grow 0, gapright push, wrap");
        add(MajicDialog.label(TEXTS.get("site"), site));
        add(site, "wrap");
        add(MajicDialog.label(TEXTS.get("site.robot"), robot));
        add(robot, "split 2, growx");
        add(list, "grow 0");
    }

    private String usualPort(boolean tls) {
        return String.valueOf(type.defaultPort(scheme(tls)));
    }

    private String scheme(boolean tls) {
        return tls ? type.otherSchemes().get(0) : type.name();
    }

    /** A port that was typed stays as it is. */
    private void changePort() {
        if (port.getText().strip().equals(usualPort(!secure.isSelected()))) {
            port.setText(usualPort(secure.isSelected()));
        }
    }

    @Override
    String address() {
        String chosen = ((JTextComponent) robot.getEditor().getEditorComponent())
                .getText()
                .strip()
                .replaceFirst(" .*", "");
        if (!chosen.matches("[^/\\s]+/\\d+")) {
            throw new BotException(TEXTS.get("site.robot.wrong"));
        }
        return siteAddress() + chosen;
    }

    /** The address of the site with a slash at its end. */
    private String siteAddress() {
        String broker = host.getText().strip();
        String path = site.getText().strip().replaceAll("^/+|/+$", "");
        if (broker.isEmpty() || broker.contains("/") || path.isEmpty() || path.matches(".*\\s.*")) {
            throw new BotException(TEXTS.get("site.missing"));
        }
        String behind = port.getText().strip();
        return scheme(secure.isSelected()) + "://" + broker + (behind.isEmpty() ? "" : ":" + behind) + "/" + path + "/";
    }

    @Override
    boolean fill(BotAddress address) {
        Matcher place = PLACE.matcher(address.rest());
        if (!type.isMeantBy(address.scheme()) || !place.matches()) {
            return false;
        }
        secure.setSelected(!address.scheme().equals(type.name()));
        host.setText(place.group(1));
        port.setText(place.group(2) == null ? usualPort(secure.isSelected()) : place.group(2));
        site.setText(place.group(3));
        robot.getEditor().setItem(place.group(4) == null ? "" : place.group(4));
        return true;
    }

    private void listRobots() {
        try {
            String address = siteAddress();
            list.setEnabled(false);
            EventThread.background(
                    "listing " + address,
                    () -> {
                        Map<String, String> found = robotsAt(address);
                        EventThread.later(() -> show(address, found));
                    },
                    this::fail);
        } catch (BotException e) {
            fail(String.valueOf(e.getMessage()));
        }
    }

    private Map<String, String> robotsAt(String address) {
        try {
            return factory.robotsAt(address);
        } catch (BotException e) {
            EventThread.later(() -> refusals.refused(e, address, this::listRobots));
            throw e;
        }
    }

    @Override
    void onRefusal(RefusalListener listener) {
        refusals = listener;
    }

    /** Offers the robots as {@code desk2/1 (Sony Aibo ERS-7)}. */
    private void show(String address, Map<String, String> found) {
        list.setEnabled(true);
        robot.removeAllItems();
        found.forEach((one, what) -> robot.addItem(one.replaceFirst(".*/([^/]+/\\d+)$", "$1") + " (" + what + ")"));
        if (found.isEmpty()) {
            fail(TEXTS.get("site.none", address));
        } else if (robot.isShowing()) {
            robot.setPopupVisible(true);
        }
    }

    private void fail(String reason) {
        list.setEnabled(true);
        firePropertyChange(PROBLEM, "", reason);
    }

    @Override
    String advice() {
        return type.advice();
    }
}
