package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Container;
import java.awt.Frame;
import java.awt.Window;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JDialog;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.SwingUtilities;
import majic.act.file.ActCatalog;
import majic.gui.acts.OwnActs;
import majic.gui.kit.Confirm;
import majic.panel.PictureView;
import majic.text.MarkedTexts;
import org.assertj.core.api.SoftAssertions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the window and all its dialogs can be used by keyboard and screen reader, and read in both looks. */
class AccessWindowTest {
    /** Entries that open no dialog. */
    private static final Set<String> EFFECTS =
            Set.of("Kill Majic", "End Act", "Start the Simulated Lab", "Show the True Positions", "Show the Whole Map");

    @TempDir
    private Path folder;

    /** What is shown without being a text: names of robots, acts, parameters, files and programs. */
    private static final Pattern DATA = Pattern.compile(
            "\\b(MAJIC|Playthings|Toy|the display of one|script\\.majic|Spy(\\.act)?|SHA-256|\\p{XDigit}{64}|me|robot2"
                    + "|text/(html|plain)|Really|Yes)\\b");

    private final Locale before = Locale.getDefault();
    private UnaryOperator<String> language = UnaryOperator.identity();
    private TestWindow window;

    private void open(Function<ActCatalog, TestWindow> opening) throws Exception {
        window = opening.apply(new OwnActs(folder)
                .script("Relay", "repeat", "1 move 100", "2 move 200", "end")
                .spy()
                .acts());
        window.add("one");
        window.add("two");
        openDialogs();
    }

    @AfterEach
    void close() throws Exception {
        SwingUtilities.invokeAndWait(FlatLightLaf::setup);
        window.close();
        System.clearProperty(OwnActs.FLAG);
        Language.use(before);
    }

    private void openDialogs() {
        Set<String> effects = EFFECTS.stream().map(language).collect(Collectors.toSet());
        entries()
                .filter(entry -> !effects.contains(entry.getText()))
                .filter(entry -> !(entry instanceof JRadioButtonMenuItem) && !(entry instanceof JCheckBoxMenuItem))
                .filter(JMenuItem::isEnabled)
                .toList()
                .forEach(entry -> window.run(entry::doClick));
        load("Spy", "Trust this code?");
        window.run(window.frame::loadAct);
        load("Relay", "Assign Roles");
        window.run(() -> Confirm.ask(window.frame, "Really?", "Yes", () -> {}));
        window.run(() -> window.frame.enlarge(new PictureView(208, 160)));
        window.run(window.frame::loadAct);
    }

    private Stream<JMenuItem> entries() {
        return IntStream.range(0, window.frame.getJMenuBar().getMenuCount())
                .mapToObj(window.frame.getJMenuBar()::getMenu)
                .flatMap(AccessWindowTest::entries);
    }

    private static Stream<JMenuItem> entries(JMenu menu) {
        return Stream.of(menu.getMenuComponents())
                .filter(JMenuItem.class::isInstance)
                .map(JMenuItem.class::cast)
                .flatMap(entry -> entry instanceof JMenu inner ? entries(inner) : Stream.of(entry));
    }

    private void load(String act, String dialog) {
        confirm("Load Act");
        window.awaitDialog(language.apply("Choose Act"));
        window.select("acts", act);
        confirm("Choose Act");
        window.awaitDialog(language.apply(dialog));
    }

    private void confirm(String title) {
        JDialog dialog = (JDialog) window.awaitDialog(language.apply(title));
        window.run(() -> dialog.getRootPane().getDefaultButton().doClick());
    }

    @Test
    @SuppressWarnings("try")
    void everyTextIsFromAResourceBundle() throws Exception {
        try (MarkedTexts marked = new MarkedTexts()) {
            language = marked::mark;
            open(TestWindow::openMarked);
            assertThat(found(root -> WindowAudit.unmarked(root, DATA))).isEmpty();
        }
    }

    @Test
    void everyComponentHasANameAMnemonicAndEnoughContrast() throws Exception {
        open(TestWindow::open);
        SoftAssertions soft = new SoftAssertions();
        soft.assertThat(found(WindowAudit::nameless))
                .as("components without an accessible name")
                .isEmpty();
        soft.assertThat(found(AccessWindowTest::mnemonicProblems))
                .as("mnemonics")
                .isEmpty();
        soft.assertThat(onEventThread(() -> WindowAudit.mnemonicProblems(window.frame.getJMenuBar())))
                .as("mnemonics of menus")
                .isEmpty();
        soft.assertThat(paleIn(new FlatLightLaf()))
                .as("pale texts in the light look")
                .isEmpty();
        soft.assertThat(paleIn(new FlatDarkLaf()))
                .as("pale texts in the dark look")
                .isEmpty();
        soft.assertAll();
    }

    /** Each window follows in an event of its own: all of them in one would keep the thread for a second. */
    private List<String> paleIn(FlatLaf look) throws Exception {
        SwingUtilities.invokeAndWait(() -> FlatLaf.setup(look));
        for (Window open : Window.getWindows()) {
            SwingUtilities.invokeAndWait(() -> SwingUtilities.updateComponentTreeUI(open));
        }
        return found(root -> WindowAudit.pale(root, Contrast.TEXT));
    }

    private static List<String> mnemonicProblems(Container root) {
        return root instanceof JDialog ? WindowAudit.mnemonicProblems(root) : List.of();
    }

    /** Returns what an audit finds in the windows that are open, with their titles. */
    private List<String> found(Function<Container, List<String>> audit) throws Exception {
        return onEventThread(() -> Stream.of(Window.getWindows())
                .filter(Window::isShowing)
                .flatMap(open -> audit.apply(open).stream().map(problem -> title(open) + ": " + problem))
                .toList());
    }

    private static String title(Window open) {
        return open instanceof JDialog dialog ? dialog.getTitle() : ((Frame) open).getTitle();
    }

    private static List<String> onEventThread(Supplier<List<String>> work) throws Exception {
        List<String> result = new ArrayList<>();
        SwingUtilities.invokeAndWait(() -> result.addAll(work.get()));
        return result;
    }
}
