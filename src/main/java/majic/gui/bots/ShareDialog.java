package majic.gui.bots;

import java.awt.Window;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.Timer;
import majic.bot.BotException;
import majic.gui.kit.EventThread;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.LoginDialog;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.Paragraph;
import majic.gui.kit.RobotSharing;
import majic.gui.kit.RobotSharing.Place;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Begins and ends the sharing of the robots with other desks, and shows whether others can reach them. */
public final class ShareDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ShareDialog.class);
    private static final int LOOK_MS = 500;

    private final transient RobotSharing sharing;
    private final JTextField broker = field("shareBroker", 28);
    private final JTextField desk = field("shareDesk", 12);
    private final JTextField person = field("sharePerson", 12);
    private final Paragraph state = new Paragraph("shareState", 4, 42);
    private final JButton share = button(TEXTS.get("share"), this::begin);
    private final JButton end = button(TEXTS.get("share.end"), this::end);
    private final Timer look = new Timer(LOOK_MS, event -> showNow());
    private boolean busy;

    /**
     * Creates the dialog.
     *
     * @param owner the window that it belongs to
     * @param sharing what shares the robots
     */
    public ShareDialog(Window owner, RobotSharing sharing) {
        super(owner, TEXTS.get("share.title"));
        HelpTopic.set(getRootPane(), "sharing-robots");
        this.sharing = sharing;
        Place place = sharing.now().orElseGet(sharing::suggested);
        broker.setText(place.broker());
        desk.setText(place.desk());
        person.setText(place.person());
        share.setName("shareBegin");
        end.setName("shareEnd");
        JPanel content = new JPanel(new MigLayout("insets 0, gap 8 10", "[right][grow, fill]", ""));
        add(content, "share.broker", broker);
        add(content, "share.desk", desk);
        add(content, "share.person", person);
        content.add(state, "spanx 2, growx, wmin 0");
        fill(content, share, end, closing(TEXTS.get("share.close")));
        state.showFaint(TEXTS.get("share.advice"));
        showNow();
    }

    private static JTextField field(String name, int columns) {
        JTextField field = new JTextField(columns);
        field.setName(name);
        return field;
    }

    private static void add(JPanel content, String text, JTextField field) {
        content.add(label(TEXTS.get(text), field));
        content.add(field, "wrap");
    }

    @Override
    public void addNotify() {
        super.addNotify();
        look.start();
    }

    @Override
    public void removeNotify() {
        look.stop();
        super.removeNotify();
    }

    private void begin() {
        Place place = new Place(
                broker.getText().strip(),
                desk.getText().strip(),
                person.getText().strip());
        if (place.broker().isEmpty()) {
            state.show(TEXTS.get("share.missing"), true);
            broker.requestFocusInWindow();
            return;
        }
        run(TEXTS.get("share.connecting", place.broker()), () -> sharing.start(place));
    }

    private void end() {
        run(TEXTS.get("share.ending"), sharing::stop);
    }

    /** Runs what may block in the background, and shows why it failed if it does. */
    private void run(String meanwhile, Runnable work) {
        busy = true;
        state.showFaint(meanwhile);
        enableParts();
        EventThread.background("sharing robots", () -> {
            Optional<BotException> refusal = attempt(work);
            EventThread.later(() -> ended(refusal));
        });
    }

    private static Optional<BotException> attempt(Runnable work) {
        try {
            work.run();
            return Optional.empty();
        } catch (BotException e) {
            return Optional.of(e);
        }
    }

    private void ended(Optional<BotException> refusal) {
        busy = false;
        if (refusal.isEmpty() && sharing.now().isEmpty()) {
            state.showFaint(TEXTS.get("share.ended"));
        }
        showNow();
        refusal.ifPresent(this::refused);
    }

    /** Shows why the sharing did not begin; asks for the user name and the password if the broker refuses them. */
    private void refused(BotException refusal) {
        state.show(String.valueOf(refusal.getMessage()), true);
        LoginDialog.askIfRefused(this, refusal, broker.getText().strip(), sharing, this::begin);
    }

    private void showNow() {
        if (!busy) {
            sharing.now().ifPresent(this::show);
        }
        enableParts();
    }

    private void show(Place place) {
        boolean connected = sharing.isConnected();
        String key = connected ? "share.shared" : "share.interrupted";
        state.show(TEXTS.get(key, place.broker(), place.desk()), !connected);
    }

    private void enableParts() {
        boolean shared = sharing.now().isPresent();
        share.setEnabled(!busy && !shared);
        end.setEnabled(!busy && shared);
        broker.setEditable(!busy && !shared);
        desk.setEditable(!busy && !shared);
        person.setEditable(!busy && !shared);
    }
}
