package majic.gui.kit;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JFileChooser;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.filechooser.FileFilter;
import javax.swing.filechooser.FileNameExtensionFilter;
import majic.environment.Settings;
import majic.text.Texts;

/** Asks for a file without blocking the window; starts in the folder where a file was chosen last. */
public final class ChooseFile extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ChooseFile.class);
    private static final String FOLDER = "window.folder";

    private final JFileChooser chooser = new Chooser();
    private final Paragraph problem = new Paragraph("fileProblem", 2, 40);
    private final JPanel content = new JPanel(new BorderLayout());
    private final transient Settings settings;
    private transient Consumer<Path> saved = file -> {};

    private ChooseFile(Window owner, Settings settings, String title, int type) {
        super(owner, title);
        this.settings = settings;
        settings.get(FOLDER).ifPresent(folder -> chooser.setCurrentDirectory(new File(folder)));
        chooser.setName("files");
        chooser.setDialogType(type);
        chooser.setApproveButtonText(title);
        problem.setBorder(BorderFactory.createEmptyBorder(0, 14, 14, 14));
        problem.setVisible(false);
        content.add(chooser, BorderLayout.CENTER);
        content.add(problem, BorderLayout.SOUTH);
        setContentPane(content);
    }

    /** Accepts the files that Load Act can load. */
    public static FileFilter acts() {
        return new FileNameExtensionFilter(TEXTS.get("acts"), "act", "majic");
    }

    /** Accepts the files that the script editor can open. */
    public static FileFilter scripts() {
        return new FileNameExtensionFilter(TEXTS.get("scripts"), "majic", "script");
    }

    /** Asks which file to open; the title is also the button's text. */
    public static void toOpen(Window owner, Settings settings, String title, FileFilter filter, Consumer<Path> chosen) {
        ChooseFile dialog = new ChooseFile(owner, settings, title, JFileChooser.OPEN_DIALOG);
        dialog.chooser.setFileFilter(filter);
        dialog.open(dialog.closingAfter(chosen));
    }

    /** Asks for the source of an act's file; a folder is accepted. */
    public static void toMakeOf(Window owner, Settings settings, Consumer<Path> chosen) {
        ChooseFile dialog = new ChooseFile(owner, settings, TEXTS.get("choose"), JFileChooser.OPEN_DIALOG);
        dialog.chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
        dialog.chooser.setFileFilter(
                new FileNameExtensionFilter(TEXTS.get("sources"), "class", "jar", "java", "majic"));
        dialog.open(dialog.closingAfter(chosen));
    }

    /** Asks for the name of a file that is written later. */
    public static void toName(Window owner, Settings settings, String title, String suggestion, Consumer<Path> chosen) {
        ChooseFile dialog = new ChooseFile(owner, settings, title, JFileChooser.SAVE_DIALOG);
        dialog.suggest(suggestion);
        dialog.open(dialog.afterConfirmation(dialog.closingAfter(chosen)));
    }

    /**
     * Asks where to save, and asks again before an existing file is overwritten. The dialog stays open until the file
     * is saved.
     *
     * @param save saves into the file; called in the background, may block; returns why it failed, empty if it did not
     */
    public static void toSave(
            Window owner, Settings settings, String title, String suggestion, Function<Path, Optional<String>> save) {
        toSave(owner, settings, title, suggestion, UnaryOperator.identity(), save);
    }

    /**
     * Asks where to save, as the other method of this name does.
     *
     * @param complete adds the ending to the name that was typed, before it is looked for whether there is such a file
     */
    public static void toSave(
            Window owner,
            Settings settings,
            String title,
            String suggestion,
            UnaryOperator<Path> complete,
            Function<Path, Optional<String>> save) {
        ChooseFile dialog = saving(owner, settings, title, suggestion);
        Consumer<Path> confirmed = dialog.afterConfirmation(file -> dialog.save(file, save));
        dialog.open(file -> confirmed.accept(complete.apply(file)));
    }

    /**
     * Something that the dialog offers to do with the saved file. Immutable.
     *
     * @param text the text of its check box
     * @param accepted receives the file if the box was checked
     */
    public record Offer(String text, Consumer<Path> accepted) {}

    /** Asks where to save, as the other method of this name does, with an offer. */
    public static void toSave(
            Window owner,
            Settings settings,
            String title,
            String suggestion,
            Function<Path, Optional<String>> save,
            Offer offer) {
        ChooseFile dialog = saving(owner, settings, title, suggestion);
        JCheckBox box = new JCheckBox(offer.text());
        box.setName("offer");
        box.setMnemonic(offer.text().charAt(0));
        box.setBorder(BorderFactory.createEmptyBorder(12, 14, 0, 14));
        dialog.content.add(box, BorderLayout.NORTH);
        dialog.saved = file -> {
            if (box.isSelected()) {
                offer.accepted().accept(file);
            }
        };
        dialog.openToSave(save);
    }

    private static ChooseFile saving(Window owner, Settings settings, String title, String suggestion) {
        ChooseFile dialog = new ChooseFile(owner, settings, title, JFileChooser.SAVE_DIALOG);
        dialog.suggest(suggestion);
        return dialog;
    }

    private void openToSave(Function<Path, Optional<String>> save) {
        open(afterConfirmation(file -> save(file, save)));
    }

    private void open(Consumer<Path> approved) {
        chooser.addActionListener(event -> {
            if (event.getActionCommand().equals(JFileChooser.APPROVE_SELECTION)) {
                approved.accept(chooser.getSelectedFile().toPath());
            } else {
                dispose();
            }
        });
        nameField().ifPresent(this::focusFirst);
        pack();
        setLocationRelativeTo(getOwner());
        setVisible(true);
    }

    private Consumer<Path> closingAfter(Consumer<Path> chosen) {
        return file -> {
            close(file);
            chosen.accept(file);
        };
    }

    private Consumer<Path> afterConfirmation(Consumer<Path> chosen) {
        return file -> {
            if (Files.exists(file)) {
                Confirm.ask(this, TEXTS.get("exists", file), TEXTS.get("overwrite"), () -> chosen.accept(file));
            } else {
                chosen.accept(file);
            }
        };
    }

    private void save(Path file, Function<Path, Optional<String>> save) {
        EventThread.background(
                "saving " + file,
                () -> {
                    Optional<String> failure = save.apply(file);
                    EventThread.later(
                            () -> failure.ifPresentOrElse(reason -> showProblem(file, reason), () -> saved(file)));
                },
                reason -> showProblem(file, reason));
    }

    private void saved(Path file) {
        close(file);
        saved.accept(file);
    }

    /** Shows why a file was not saved; its whole name stays in the field, also if its folder does not exist. */
    private void showProblem(Path file, String reason) {
        nameField().ifPresent(field -> field.setText(file.toString()));
        problem.show(reason, true);
        problem.setVisible(true);
        pack();
    }

    /** Closes the dialog; the next one starts in the folder of this file. */
    private void close(Path file) {
        dispose();
        Path folder = file.toAbsolutePath().getParent();
        if (folder != null) {
            BackgroundSettings.put(settings, FOLDER, folder.toString());
        }
    }

    /** Suggests a name, with its part before the ending selected, so that typing replaces it. */
    private void suggest(String name) {
        File file = new File(name);
        chooser.setSelectedFile(file);
        int dot = file.getName().lastIndexOf('.');
        int end = dot < 0 ? file.getName().length() : dot;
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                nameField().ifPresent(field -> field.select(0, end));
            }
        });
    }

    private Optional<JTextField> nameField() {
        return textFields(chooser).findFirst();
    }

    private static Stream<JTextField> textFields(Container container) {
        return Stream.of(container.getComponents()).flatMap(ChooseFile::textFieldsIn);
    }

    private static Stream<JTextField> textFieldsIn(Component component) {
        if (component instanceof JTextField field) {
            return Stream.of(field);
        }
        return component instanceof Container container ? textFields(container) : Stream.empty();
    }

    /**
     * Keeps the words of a dialog that saves when the look and feel changes: each look and feel begins with those of
     * opening.
     */
    private static final class Chooser extends JFileChooser {
        private static final long serialVersionUID = 1L;

        @Override
        public void updateUI() {
            super.updateUI();
            firePropertyChange(DIALOG_TYPE_CHANGED_PROPERTY, OPEN_DIALOG, getDialogType());
        }
    }
}
