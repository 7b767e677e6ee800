package majic.gui.acts;

import java.awt.Window;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ListSelectionModel;
import majic.environment.Settings;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.DoubleClick;
import majic.gui.kit.EventThread;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.MajicDialog;
import majic.script.ActOffer;
import majic.script.ActOffers;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/**
 * Chooses the act for one or several robots: one that needs no path, or a file; shows for each what it is and whether
 * the robots can run it.
 */
final class ChooseActDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ChooseActDialog.class);

    private final transient ActOffers offers;
    private final transient Settings settings;
    private final transient LoadTargets targets;
    private final transient Consumer<ChosenAct> chosen;
    private final DefaultListModel<ActEntry> entries = new DefaultListModel<>();
    private final JList<ActEntry> list = new JList<>(entries);
    private final ActSummary summary = new ActSummary();
    private final ArgumentsForm arguments = new ArgumentsForm(this::enableLoad);
    private final JButton load = button(TEXTS.get("load"), this::load);

    ChooseActDialog(
            Window owner, ActOffers offers, Settings settings, LoadTargets targets, Consumer<ChosenAct> chosen) {
        super(owner, TEXTS.get("chooseAct"));
        HelpTopic.set(getRootPane(), "loading-acts");
        this.offers = offers;
        this.settings = settings;
        this.targets = targets;
        this.chosen = chosen;
        load.setName("loadChosen");
        fill(content(), load, closing(TEXTS.get("cancel")));
        show(null);
    }

    /** Shows the dialog, and lists the acts as soon as they are read. */
    void open() {
        readAll(() -> {});
        setVisible(true);
    }

    /** Shows the dialog, and selects the act of a file as soon as the listed ones are read. */
    void open(Path file) {
        readAll(() -> readFile(file));
        setVisible(true);
    }

    private JPanel content() {
        list.setName("acts");
        list.setCellRenderer(new ActCell(targets));
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.addListSelectionListener(event -> show(list.getSelectedValue()));
        list.addMouseListener(new DoubleClick(load::doClick));
        JPanel panel = new JPanel(new MigLayout(
                "insets 0, gap 14 8", "[200:250:, fill][320:380:, grow, fill]", "[][400::, grow, fill][]"));
        panel.add(new JLabel(targets.heading()), "spanx 2, wrap");
        panel.add(new JScrollPane(list));
        JPanel described =
                new JPanel(new MigLayout("insets 0, gap 0 8, wrap 1, hidemode 3", "[grow, fill]", "[][grow, fill]"));
        described.add(summary, "wmin 0");
        described.add(arguments, "wmin 0");
        panel.add(described, "wmin 0, spany 2, wrap");
        panel.add(button(TEXTS.get("fromFile"), this::chooseFile));
        return panel;
    }

    private void chooseFile() {
        ChooseFile.toOpen(getOwner(), settings, TEXTS.get("choose"), ChooseFile.acts(), this::readFile);
    }

    private void readAll(Runnable then) {
        summary.say(TEXTS.get("reading"));
        EventThread.background(
                "reading acts",
                () -> {
                    List<ActEntry> all = ActEntry.readAll(offers);
                    EventThread.later(() -> {
                        fillList(all);
                        then.run();
                    });
                },
                summary::complain);
    }

    private void fillList(List<ActEntry> all) {
        entries.addAll(all);
        if (list.isSelectionEmpty()) {
            summary.say(TEXTS.get(all.isEmpty() ? "noAct" : "chooseOne"));
        }
    }

    /** Shows an act from a file in the same way as the listed ones, before it is loaded. */
    private void readFile(Path file) {
        EventThread.background(
                "reading " + file,
                () -> {
                    ActEntry entry = ActEntry.read(offers, file.toAbsolutePath().toString());
                    EventThread.later(() -> showFile(entry));
                },
                summary::complain);
    }

    private void showFile(ActEntry entry) {
        if (entry.offer() == null) {
            list.clearSelection();
            summary.complain(entry.note());
            return;
        }
        entries.add(0, entry);
        list.setSelectedIndex(0);
        list.ensureIndexIsVisible(0);
    }

    private void show(@Nullable ActEntry entry) {
        ActOffer offer = entry == null ? null : entry.offer();
        arguments.show(offer == null ? List.of() : offer.arguments());
        if (entry != null) {
            summary.show(entry, targets.unfit(entry));
        }
        enableLoad();
    }

    private void enableLoad() {
        ActEntry entry = list.getSelectedValue();
        load.setEnabled(entry != null && targets.unfit(entry).isEmpty() && arguments.isComplete());
    }

    private void load() {
        ActEntry entry = list.getSelectedValue();
        if (entry != null && entry.offer() != null) {
            dispose();
            chosen.accept(new ChosenAct(entry.offer(), arguments.values()));
        }
    }
}
