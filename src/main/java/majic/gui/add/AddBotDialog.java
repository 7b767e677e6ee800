package majic.gui.add;

import java.awt.CardLayout;
import java.awt.Window;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.Timer;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.gui.kit.EventThread;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.LoginDialog;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.Paragraph;
import majic.gui.kit.ProgramServices;
import majic.link.PortSearch;
import majic.script.Session;
import majic.team.Member;
import majic.text.Advice;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/**
 * Connects a robot: its type, then its address. Connecting continues in the background, is shown, can be cancelled, and
 * ends by itself after a timeout; errors and what to try next are shown here.
 */
public final class AddBotDialog extends MajicDialog {
    /** Timeout of a connection attempt in ms; longer than any driver's own timeout, which it backs up. */
    public static final int GIVE_UP_MS = 20_000;

    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(AddBotDialog.class);

    private final transient Session session;
    private final transient ProgramServices services;
    private final transient Consumer<Member> joined;
    private final transient Map<String, AddressInput> inputs;
    private final JComboBox<String> type = new JComboBox<>();
    private final JComboBox<String> recent = new JComboBox<>();
    private final JButton search = button(TEXTS.get("search"), this::search);
    private final CardLayout cards = new CardLayout();
    private final JPanel deck = new JPanel(cards);
    private final JProgressBar progress = new JProgressBar();
    private final Paragraph message = new Paragraph("outcome", 5, 42);
    private final JButton ok = button(TEXTS.get("ok"), this::connect);
    private final Timer giveUp;
    private transient @Nullable ConnectAttempt attempt;

    /**
     * Creates a dialog that is not shown yet.
     *
     * @param joined receives a robot that was added
     * @param giveUpMs timeout of an attempt, ms
     */
    public AddBotDialog(
            Window owner, Session session, ProgramServices services, Consumer<Member> joined, int giveUpMs) {
        this(owner, session, services, joined, giveUpMs, inputs(session, services));
    }

    private static Map<String, AddressInput> inputs(Session session, ProgramServices services) {
        Map<String, AddressInput> inputs = new LinkedHashMap<>();
        AddressInputFactory.all(session.factory(), services).forEach((name, input) -> inputs.put(name, input.get()));
        return inputs;
    }

    private AddBotDialog(
            Window owner,
            Session session,
            ProgramServices services,
            Consumer<Member> joined,
            int giveUpMs,
            Map<String, AddressInput> inputs) {
        super(owner, TEXTS.get("addBot"));
        HelpTopic.set(getRootPane(), "adding-a-robot");
        this.session = session;
        this.services = services;
        this.joined = joined;
        this.inputs = inputs;
        this.giveUp = new Timer(giveUpMs, event -> giveUp());
        giveUp.setRepeats(false);
        fill(content(), ok, closing(TEXTS.get("cancel")));
    }

    /**
     * Creates a dialog in pieces of the event dispatch thread: first the fields of each type, then the dialog.
     *
     * @param open receives, in the last piece, what creates the dialog
     */
    public static void inPieces(
            Window owner,
            Session session,
            ProgramServices services,
            Consumer<Member> joined,
            Consumer<Supplier<AddBotDialog>> open) {
        Map<String, AddressInput> inputs = new LinkedHashMap<>();
        AddressInputFactory.all(session.factory(), services)
                .forEach((name, input) -> EventThread.piece(() -> inputs.put(name, input.get())));
        EventThread.piece(
                () -> open.accept(() -> new AddBotDialog(owner, session, services, joined, GIVE_UP_MS, inputs)));
    }

    private JPanel content() {
        type.setName("type");
        inputs.forEach((name, input) -> {
            type.addItem(name);
            deck.add(input, name);
            input.addPropertyChangeListener(
                    AddressInput.PROBLEM, event -> message.show(String.valueOf(event.getNewValue()), true));
            input.onRefusal(this::askLogin);
        });
        type.addActionListener(event -> {
            cards.show(deck, chosen());
            message.show("", false);
        });
        message.setFocusable(true);
        progress.setVisible(false);
        JPanel panel = new JPanel(new MigLayout("insets 0, gap 8 10", "[90!, right][grow, fill]", ""));
        addRecent(panel);
        panel.add(label(TEXTS.get("type"), type));
        panel.add(type, "wrap");
        panel.add(deck, "spanx 2, growx, wrap");
        panel.add(search, "skip 1, grow 0, gapbottom 4, wrap");
        panel.add(progress, "spanx 2, growx, h 6!, wrap");
        panel.add(message, "spanx 2, grow, wmin 0");
        return panel;
    }

    /** Offers the robots that were connected last, if there are any. */
    private void addRecent(JPanel panel) {
        List<String> addresses = new RecentRobots(services.settings())
                .all().stream().filter(this::isKnown).toList();
        if (addresses.isEmpty()) {
            return;
        }
        recent.setName("recentRobots");
        recent.addItem(TEXTS.get("recent.none"));
        addresses.forEach(recent::addItem);
        recent.addActionListener(event -> {
            if (recent.getSelectedIndex() > 0) {
                fillIn(String.valueOf(recent.getSelectedItem()));
            }
        });
        panel.add(label(TEXTS.get("recent"), recent));
        panel.add(recent, "wrap");
    }

    /** Returns whether there are fields for an address. */
    private boolean isKnown(String address) {
        return BotAddress.parse(address).library().isEmpty()
                && session.factory().types().stream()
                        .anyMatch(known ->
                                known.name().equals(BotAddress.parse(address).type()));
    }

    /** Selects the type and fills in the fields for an address. */
    private void fillIn(String address) {
        BotAddress wanted = BotAddress.parse(address);
        inputs.entrySet().stream()
                .filter(input -> input.getValue().fill(wanted))
                .findFirst()
                .ifPresent(input -> type.setSelectedItem(input.getKey()));
    }

    private void search() {
        SearchDialog.Places places = new SearchDialog.Places(
                PortSearch::neighbours,
                () -> TeamPlaces.of(session),
                services.serialPorts(),
                session.factory()::robotsSending);
        new SearchDialog(this, session.factory().types(), places, this::fillIn).setVisible(true);
    }

    private String chosen() {
        return Objects.requireNonNull((String) type.getSelectedItem());
    }

    private AddressInput input() {
        return Objects.requireNonNull(inputs.get(chosen()));
    }

    private void connect() {
        try {
            String address = input().address();
            busy(true);
            message.show(TEXTS.get("connecting", address), false);
            attempt = new ConnectAttempt(session, address, new Ending(address));
            attempt.start();
            giveUp.restart();
        } catch (BotException e) {
            message.show(String.valueOf(e.getMessage()), true);
        }
    }

    private void askLogin(BotException refusal, String address, Runnable again) {
        LoginDialog.askIfRefused(this, refusal, address, services.sharing(), again);
    }

    private void giveUp() {
        abandon();
        message.show(TEXTS.get("timeout", giveUp.getInitialDelay() / 1000, input().advice()), true);
    }

    private void busy(boolean connecting) {
        ok.setEnabled(!connecting);
        type.setEnabled(!connecting);
        recent.setEnabled(!connecting);
        search.setEnabled(!connecting);
        progress.setIndeterminate(connecting);
        progress.setVisible(connecting);
    }

    private void abandon() {
        giveUp.stop();
        if (attempt != null) {
            attempt.cancel();
            attempt = null;
        }
        busy(false);
    }

    /** Cancels a running attempt, however the dialog is closed. */
    @Override
    public void dispose() {
        abandon();
        super.dispose();
    }

    /** Receives the result of the running attempt. */
    private final class Ending implements ConnectAttempt.Outcome {
        private final String address;

        Ending(String address) {
            this.address = address;
        }

        @Override
        public void joined(Member member) {
            attempt = null;
            dispose();
            joined.accept(member);
        }

        @Override
        public void failed(BotException reason) {
            giveUp.stop();
            attempt = null;
            busy(false);
            message.show(Advice.after(String.valueOf(reason.getMessage()), input().advice()), true);
            askLogin(reason, address, AddBotDialog.this::connect);
        }
    }
}
