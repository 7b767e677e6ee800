package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SaveFileWindowTest {
    @TempDir
    private Path folder;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    @Test
    void typingReplacesTheSuggestedNameAndKeepsItsEnding() {
        window.click("Save Session");
        window.awaitShowing("files", JFileChooser.class);
        window.await("the suggested name", () -> window.selectedFileName().equals("session"));
        window.type("lap");
        assertThat(window.fileName()).isEqualTo("lap.majic");
    }

    @Test
    void theDialogStaysOpenUntilTheFileIsSaved() {
        window.click("Save Session");
        window.chooseFile(folder.resolve("missing").resolve("lap.majic"));
        window.await("the reason", () -> window.text("fileProblem").contains("cannot be written"));
        assertThat(window.isShowing("files")).isTrue();
        assertThat(window.fileName())
                .isEqualTo(folder.resolve("missing").resolve("lap.majic").toString());

        window.chooseFile(folder.resolve("lap.majic"));
        window.await("the dialog to close", () -> !window.isShowing("files"));
        assertThat(folder.resolve("lap.majic")).isRegularFile();
    }

    @Test
    void theNextDialogStartsInTheFolderOfTheLastFile() {
        window.click("Save Session");
        window.chooseFile(folder.resolve("lap.majic"));
        window.await(
                "the folder to be stored",
                () -> window.settings.get("window.folder").isPresent());
        window.click("Save Log");
        JFileChooser chooser = window.awaitShowing("files", JFileChooser.class);
        window.run(() -> assertThat(chooser.getCurrentDirectory()).isEqualTo(folder.toFile()));
    }

    @Test
    void aDialogThatSavesDoesSoInTheOtherLookToo() {
        window.click("Save Session");
        JFileChooser chooser = window.awaitShowing("files", JFileChooser.class);
        try {
            window.run(() -> LookAndFeels.change(true, window.settings));
            window.await(
                    "the labels of the new look",
                    () -> labels(chooser).stream().anyMatch(text -> text.startsWith("Save In")));
        } finally {
            window.run(() -> LookAndFeels.change(false, window.settings));
        }
    }

    private static List<String> labels(Container parent) {
        return Stream.of(parent.getComponents())
                .flatMap(part -> part instanceof JLabel label && label.getText() != null
                        ? Stream.of(label.getText())
                        : part instanceof Container inner ? labels(inner).stream() : Stream.empty())
                .toList();
    }
}
