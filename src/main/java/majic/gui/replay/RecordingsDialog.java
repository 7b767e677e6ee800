package majic.gui.replay;

import java.awt.Window;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.filechooser.FileNameExtensionFilter;
import majic.bot.BotException;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.DoubleClick;
import majic.gui.kit.EventThread;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.Paragraph;
import majic.recorder.RecordingFolder;
import majic.recorder.RecordingHead;
import majic.recorder.RecordingSummary;
import majic.text.IoReason;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Asks which recording is to be replayed: one of the user's folder, the newest first, or another file. */
public final class RecordingsDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(RecordingsDialog.class);
    private static final double MEGABYTE = 1e6;

    private final transient ReplayServices services;
    private final DefaultListModel<Entry> entries = new DefaultListModel<>();
    private final JList<Entry> list = new JList<>(entries);
    private final Paragraph problem = new Paragraph("recordingProblem", 2, 40);
    private volatile boolean closed;
    private final JButton open = button(TEXTS.get("open"), this::openSelected);

    /** A file with the words for it. */
    private record Entry(Path file, String words) {
        @Override
        public String toString() {
            return words;
        }
    }

    /**
     * Creates the dialog; it lists the recordings as soon as they are found.
     *
     * @param owner the window beside which recordings are opened
     * @param folder where the recordings are
     * @param services what a replay needs
     */
    public RecordingsDialog(Window owner, RecordingFolder folder, ReplayServices services) {
        super(owner, TEXTS.get("openRecording"));
        HelpTopic.set(getRootPane(), "replaying-a-recording");
        this.services = services;
        list.setName("recordings");
        list.setVisibleRowCount(10);
        list.getAccessibleContext().setAccessibleName(TEXTS.get("recordings"));
        list.addListSelectionListener(event -> open.setEnabled(list.getSelectedValue() != null));
        list.addMouseListener(new DoubleClick(this::openSelected));
        JPanel content = new JPanel(new MigLayout("insets 0, wrap 1", "[grow, fill]", "[][grow, fill][]"));
        content.add(label(TEXTS.get("recordings"), list));
        content.add(new JScrollPane(list), "w 640, h 220");
        content.add(problem, "wmin 0");
        open.setEnabled(false);
        fill(content, open, button(TEXTS.get("otherFile"), this::chooseFile), closing(TEXTS.get("cancel")));
        EventThread.background(
                "listing recordings",
                () -> {
                    List<Entry> found = entries(folder);
                    EventThread.later(() -> show(found));
                    complete(found);
                },
                this::showProblem);
    }

    private void show(List<Entry> found) {
        entries.addAll(found);
        list.setSelectedIndex(0);
        if (found.isEmpty()) {
            problem.show(TEXTS.get("noRecording"), false);
        }
    }

    /** Adds length and robots to each entry, which means to read the whole file, until the dialog is closed. */
    private void complete(List<Entry> found) {
        for (int index = 0; index < found.size() && !closed; index++) {
            int row = index;
            Entry entry = found.get(row);
            completed(entry).ifPresent(whole -> EventThread.later(() -> entries.set(row, whole)));
        }
    }

    private static Optional<Entry> completed(Entry entry) {
        try {
            RecordingSummary summary = RecordingSummary.read(entry.file());
            String robots = summary.robots().isEmpty()
                    ? TEXTS.get("noRobots")
                    : summary.robots().stream()
                            .map(robot -> robot.number() + " " + robot.label())
                            .collect(Collectors.joining(", "));
            String length = ReplayTimes.clock(summary.lengthS());
            return Optional.of(new Entry(entry.file(), TEXTS.get("entry.whole", entry.words(), length, robots)));
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /** Ends the reading of files, too. */
    @Override
    public void dispose() {
        closed = true;
        super.dispose();
    }

    private static List<Entry> entries(RecordingFolder folder) {
        try {
            List<Entry> entries = new ArrayList<>();
            for (Path file : folder.files()) {
                entries.add(0, new Entry(file, words(file)));
            }
            return entries;
        } catch (IOException e) {
            throw new BotException(TEXTS.get("notListed", IoReason.of(e)), e);
        }
    }

    private static String words(Path file) {
        try {
            RecordingHead head = RecordingHead.read(file);
            String begin = ReplayTimes.day(head.begin());
            String name = head.part() == 1
                    ? begin
                    : TEXTS.get("partFrom", begin, head.part(), ReplayTimes.timeOfDay(head.timeOfDay(head.beginS())));
            return TEXTS.get("entry", name, Files.size(file) / MEGABYTE);
        } catch (IOException e) {
            return file.getFileName() + "  \u00b7  " + TEXTS.get("unreadable");
        }
    }

    private void chooseFile() {
        FileNameExtensionFilter filter = new FileNameExtensionFilter(
                TEXTS.get("files", RecordingFolder.ENDING), RecordingFolder.ENDING.substring(1));
        ChooseFile.toOpen(this, services.settings(), TEXTS.get("open"), filter, this::open);
    }

    private void openSelected() {
        Entry entry = list.getSelectedValue();
        if (entry != null) {
            open(entry.file());
        }
    }

    private void open(Path file) {
        open.setEnabled(false);
        ReplayWindow.open(getOwner(), file, services, this::dispose, this::showProblem);
    }

    private void showProblem(String reason) {
        open.setEnabled(list.getSelectedValue() != null);
        problem.show(reason, true);
    }
}
