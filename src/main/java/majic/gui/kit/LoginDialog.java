package majic.gui.kit;

import java.awt.Window;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JPasswordField;
import javax.swing.JTextField;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/**
 * Asks for the user name and the password of a broker that refuses those it was given. They are kept in memory until
 * the program ends, and are shown and written nowhere.
 */
public final class LoginDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(LoginDialog.class);
    private static final Pattern BROKER = Pattern.compile("\\w+://([^/]+).*");

    private final String broker;
    private final transient RobotSharing sharing;
    private final transient Runnable again;
    private final transient Predicate<String> commands;
    private final JTextField user = new JTextField(16);
    private final JPasswordField password = new JPasswordField(16);

    private LoginDialog(
            Window owner, String address, RobotSharing sharing, Runnable again, Predicate<String> commands) {
        super(owner, TEXTS.get("login.title"));
        HelpTopic.set(getRootPane(), "sharing-robots");
        this.broker = address;
        this.sharing = sharing;
        this.again = again;
        this.commands = commands;
        user.setName("loginUser");
        password.setName("loginPassword");
        Paragraph question = new Paragraph("loginQuestion", 2, 42);
        question.showFaint(TEXTS.get("login.question", nameOf(address)));
        JPanel content = new JPanel(new MigLayout("insets 0, gap 8 10", "[right][grow, fill]", ""));
        content.add(question, "spanx 2, growx, wmin 0, wrap");
        content.add(label(TEXTS.get("login.user"), user));
        content.add(user, "wrap");
        content.add(label(TEXTS.get("login.password"), password));
        content.add(password);
        JButton ok = button(TEXTS.get("login.ok"), this::use);
        ok.setName("loginOk");
        fill(content, ok, closing(TEXTS.get("login.cancel")));
    }

    /**
     * Opens the dialog if a broker has refused the user name or the password, unless it is open for this broker and
     * owner already.
     *
     * @param owner the window that it belongs to
     * @param failure why a connection was not made
     * @param address any address at the broker
     * @param sharing takes what is typed; null if the program cannot use it, and then nothing is asked
     * @param again what is done when it was typed, on the event dispatch thread
     */
    public static void askIfRefused(
            Window owner, BotException failure, String address, @Nullable RobotSharing sharing, Runnable again) {
        if (sharing != null
                && failure instanceof ConnectFailed failed
                && failed.reason() == ConnectFailed.Reason.WRONG_LOGIN) {
            ask(owner, address, sharing, again, typed -> false);
        }
    }

    /**
     * Opens the dialog, as {@link #askIfRefused} does, while the user may be typing a command.
     *
     * @param commands executes a user name that is a command, such as a stop; returns false if it is none
     */
    public static void ask(
            Window owner, String address, RobotSharing sharing, Runnable again, Predicate<String> commands) {
        find(owner, address)
                .ifPresentOrElse(
                        Window::toFront,
                        () -> new LoginDialog(owner, address, sharing, again, commands).setVisible(true));
    }

    /** Returns the dialog of an owner that is open for the broker of an address. */
    public static Optional<LoginDialog> find(Window owner, String address) {
        return Stream.of(owner.getOwnedWindows())
                .filter(LoginDialog.class::isInstance)
                .map(LoginDialog.class::cast)
                .filter(dialog -> dialog.isShowing() && nameOf(dialog.broker).equals(nameOf(address)))
                .findFirst();
    }

    /**
     * Returns the name of the broker in an address.
     *
     * @return its host, and its port if there is one; the address itself if it names no broker
     */
    public static String nameOf(String address) {
        Matcher matcher = BROKER.matcher(address);
        return matcher.matches() ? matcher.group(1) : address;
    }

    private void use() {
        String name = user.getText().strip();
        if (name.isEmpty()) {
            user.requestFocusInWindow();
            return;
        }
        if (commands.test(name)) {
            user.setText("");
            return;
        }
        char[] secret = password.getPassword();
        sharing.useLogin(broker, name, secret);
        Arrays.fill(secret, ' ');
        dispose();
        again.run();
    }
}
