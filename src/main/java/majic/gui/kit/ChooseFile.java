package majic.gui.kit;

import java.awt.Window;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileFilter;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Asks for a file without blocking the window. */
public final class ChooseFile extends MajicDialog {
    private static final long serialVersionUID = 1L;

    /** Accepts the files that Load Act can load. */
    public static final FileFilter ACTS =
            new FileNameExtensionFilter("Behaviours and scripts (.act, .majic)", "act", "majic");

    private static final FileFilter SOURCES = new FileNameExtensionFilter(
            "Classes, jars, sources and scripts (.class, .jar, .java, .majic)", "class", "jar", "java", "majic");

    private final JFileChooser chooser = new JFileChooser();
    private final transient Consumer<Path> chosen;

    private ChooseFile(Window owner, String title, int type, Consumer<Path> chosen) {
        super(owner, title);
        this.chosen = chosen;
        chooser.setName("files");
        chooser.setDialogType(type);
        chooser.setApproveButtonText(title);
        chooser.addActionListener(event -> ended(event.getActionCommand()));
        setContentPane(chooser);
        pack();
        setLocationRelativeTo(owner);
    }

    /** Asks which file to open; the title is also the button's text. */
    public static void toOpen(Window owner, String title, FileFilter filter, Consumer<Path> chosen) {
        ChooseFile dialog = new ChooseFile(owner, title, JFileChooser.OPEN_DIALOG, chosen);
        dialog.chooser.setFileFilter(filter);
        dialog.setVisible(true);
    }

    /** Asks for the source of an act's file; a folder is accepted. */
    public static void toMakeOf(Window owner, Consumer<Path> chosen) {
        ChooseFile dialog = new ChooseFile(owner, "Choose", JFileChooser.OPEN_DIALOG, chosen);
        dialog.chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
        dialog.chooser.setFileFilter(SOURCES);
        dialog.setVisible(true);
    }

    /** Asks where to save, and asks again before an existing file is overwritten. */
    public static void toSave(Window owner, String title, String suggestion, Consumer<Path> chosen) {
        Consumer<Path> careful = file -> {
            if (Files.exists(file)) {
                Confirm.ask(owner, file + " exists. Overwrite it?", "Overwrite", () -> chosen.accept(file));
            } else {
                chosen.accept(file);
            }
        };
        ChooseFile dialog = new ChooseFile(owner, title, JFileChooser.SAVE_DIALOG, careful);
        dialog.chooser.setSelectedFile(new File(suggestion));
        dialog.setVisible(true);
    }

    private void ended(String command) {
        if (command.equals(JFileChooser.APPROVE_SELECTION)) {
            chosen.accept(chooser.getSelectedFile().toPath());
        }
        dispose();
    }
}
