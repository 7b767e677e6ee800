package majic.gui.plot;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.awt.datatransfer.Transferable;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JPanel;
import javax.swing.JRootPane;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.TransferHandler.TransferSupport;
import javax.swing.event.ListDataEvent;
import javax.swing.event.ListDataListener;
import majic.bot.Pose;
import majic.gui.Contrast;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import majic.gui.WindowAudit;
import majic.gui.plot.data.LiveSource;
import majic.panel.PlotHost;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PlotWindowTest {
    @TempDir
    private Path folder;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    private void plotPose() {
        window.awaitShowing("pose1", JLabel.class);
        window.focus("pose1");
        window.press(KeyEvent.VK_ENTER);
        window.awaitShowing("plot", JFrame.class);
    }

    private List<String> curves() {
        JPanel list = window.awaitShowing("curves", JPanel.class);
        return Stream.of(list.getComponents())
                .map(Component::getName)
                .filter(name -> name != null && name.startsWith("curve "))
                .map(name -> name.substring("curve ".length()))
                .toList();
    }

    @Test
    void theButtonShowsTheWholeWordForALatchedStop() {
        window.add("one");
        plotPose();

        window.run(window.team::stopAll);

        window.await("the latch", () -> window.text("smallStop").equals("STOPPED"));
        JButton stop = window.find("smallStop", JButton.class);
        JFrame plot = window.find("plot", JFrame.class);
        window.await("the whole word", () -> stop.getWidth() >= stop.getPreferredSize().width);
        window.run(() -> plot.setSize(plot.getMinimumSize()));
        window.await(
                "the button in a small window",
                () -> stop.getX() + stop.getPreferredSize().width
                        <= stop.getParent().getWidth());
    }

    @Test
    @Tag("jdk")
    void aClickOnANumberPlotsIt() {
        window.add("one");
        window.awaitShowing("pose1", JLabel.class);
        window.await("its place", () -> window.text("pose1").startsWith("x "));
        window.run(window.frame::validate);
        window.holdMouse("pose1");
        window.letGoMouse();
        window.await("a plot", () -> window.isShowing("plot"));
        assertThat(curves()).containsExactly("1 x (mm)");
    }

    @Test
    void enterPlotsTheReadingsThatHaveTheFocus() {
        window.add("one");
        plotPose();
        assertThat(curves()).containsExactly("1 x (mm)", "1 y (mm)", "1 heading (°)");
    }

    @Test
    void theSpaceBarPausesANewPlot() {
        window.add("one");
        plotPose();
        Component chart = window.find("chart", Component.class);
        window.await("the focus", chart::isFocusOwner);
        window.press(KeyEvent.VK_SPACE);
        JToggleButton pause = window.find("pause", JToggleButton.class);
        window.await("the pause", pause::isSelected);
    }

    @Test
    void plusZoomsAndZeroShowsTheNewestReadings() {
        window.add("one");
        plotPose();
        Component chart = window.find("chart", Component.class);
        window.await("the focus", chart::isFocusOwner);
        window.await("the zoom", () -> {
            window.type("+");
            return window.isEnabled("showNewest");
        });
        window.type("0");
        window.await("the end of the zoom", () -> !window.isEnabled("showNewest"));
    }

    @Test
    void thePlotFollowsTheReports() {
        ToyBot bot = window.add("one");
        plotPose();
        bot.at(new Pose(120, -30, 45), true);
        window.await("the newest value", () -> window.text("value 1 x (mm)").equals("120 mm"));
    }

    @Test
    void curvesOfSeveralRobotsAreAddedAndRemoved() {
        window.add("one");
        window.add("two");
        plotPose();
        window.push("addCurves");
        window.write("curveFilter", "2 turn");
        window.push("Add");
        window.await("the curve", () -> curves().contains("2 turnRate (°/s)"));
        window.push("remove 1 y (mm)");
        assertThat(curves()).containsExactly("1 x (mm)", "1 heading (°)", "2 turnRate (°/s)");
    }

    /**
     * A list that measures its rows asks for each of them at each change, which blocks the keys of STOP with many
     * robots.
     */
    @Test
    void aLetterThatFindsParametersChangesTheListTwiceAndMeasuresNoRow() {
        window.add("one");
        window.add("two");
        plotPose();
        window.push("addCurves");
        JList<?> parameters = window.awaitShowing("parameters", JList.class);
        AtomicInteger changes = new AtomicInteger();
        ListDataListener counting = listening(changes::incrementAndGet);
        window.run(() -> parameters.getModel().addListDataListener(counting));
        window.run(() -> window.find("curveFilter", JTextField.class).setText("t"));
        assertThat(changes).hasValue(2);
        assertThat(parameters.getFixedCellHeight()).isPositive();
        assertThat(parameters.getFixedCellWidth()).isPositive();
    }

    private static ListDataListener listening(Runnable action) {
        return new ListDataListener() {
            @Override
            public void intervalAdded(ListDataEvent event) {
                action.run();
            }

            @Override
            public void intervalRemoved(ListDataEvent event) {
                action.run();
            }

            @Override
            public void contentsChanged(ListDataEvent event) {
                action.run();
            }
        };
    }

    private boolean drop(Transferable dragged) {
        JRootPane plot = window.awaitShowing("plot", JFrame.class).getRootPane();
        boolean[] accepted = new boolean[1];
        window.run(() -> accepted[0] = plot.getTransferHandler().importData(new TransferSupport(plot, dragged)));
        return accepted[0];
    }

    @Test
    void aReadingThatIsDroppedOnAPlotAddsItsCurve() {
        window.add("one");
        window.add("two");
        plotPose();
        assertThat(drop(((PlotHost) window.find("tab2", JPanel.class)).dragged(List.of("x"))))
                .isTrue();
        assertThat(curves()).containsExactly("1 x (mm)", "1 y (mm)", "1 heading (°)", "2 x (mm)");
    }

    @Test
    void aPlotRefusesReadingsOfAnotherSource() {
        window.add("one");
        plotPose();
        try (Plots others =
                new Plots(window.frame, window.settings, () -> new LiveSource(window.team, null), JPanel::new)) {
            assertThat(drop(others.dragged(1, List.of("turnRate")))).isFalse();
        }
        assertThat(curves()).containsExactly("1 x (mm)", "1 y (mm)", "1 heading (°)");
    }

    @Test
    void csvContainsTheReadingsOfTheTimeShown() throws IOException {
        ToyBot bot = window.add("one");
        plotPose();
        bot.at(new Pose(120, -30, 45), true);
        window.await("the newest value", () -> window.text("value 1 x (mm)").equals("120 mm"));
        window.push("saveCsv");
        window.chooseFile(folder.resolve("plot.csv"));
        window.await("the file", () -> !window.isShowing("files"));
        List<String> lines = Files.readAllLines(folder.resolve("plot.csv"));
        assertThat(lines.get(0)).isEqualTo("time_s,robot,parameter,value,unit");
        assertThat(lines).anyMatch(line -> line.matches("\\d+\\.\\d{3},1,x,120\\.0,mm"));
        assertThat(lines).anyMatch(line -> line.matches("\\d+\\.\\d{3},1,heading,45\\.0,deg"));
    }

    @Test
    void pngIsAPictureOfTheChart() throws IOException {
        window.add("one");
        plotPose();
        window.push("savePng");
        window.chooseFile(folder.resolve("plot.png"));
        window.await("the file", () -> !window.isShowing("files"));
        assertThat(ImageIO.read(folder.resolve("plot.png").toFile()).getWidth()).isGreaterThan(400);
    }

    @Test
    void ctrlWClosesThePlot() {
        window.add("one");
        plotPose();
        JFrame plot = window.find("plot", JFrame.class);
        window.await("the focus", plot::isFocused);
        window.pressWithCtrl(KeyEvent.VK_W);
        window.await("the end of the plot", () -> !plot.isDisplayable());
    }

    @Test
    void theWindowMenuListsThePlotsAndBringsOneToTheFront() {
        window.add("one");
        openWindowMenu();
        assertThat(window.entry("No other windows are open").isEnabled()).isFalse();
        window.press(KeyEvent.VK_ESCAPE);
        plotPose();
        JFrame plot = window.find("plot", JFrame.class);
        window.await("the focus of the plot", plot::isFocused);
        window.run(window.frame::toFront);
        window.focus("commandLine");
        window.await("the focus of the main window", window.frame::isFocused);

        openWindowMenu();
        window.run(window.entry("Plot: 1 x, 1 y, 1 heading")::doClick);

        window.await("the focus of the plot", plot::isFocused);
    }

    private void openWindowMenu() {
        JMenuBar bar = window.frame.getJMenuBar();
        JMenu menu = bar.getMenu(bar.getMenuCount() - 2);
        assertThat(menu.getText()).isEqualTo("Window");
        window.run(menu::doClick);
    }

    @Test
    void stopKeysStopTheRobotsInThePlotToo() {
        ToyBot bot = window.add("one");
        plotPose();
        window.press(KeyEvent.VK_F12);
        window.await("the stop", () -> bot.told.contains("halt"));
    }

    @Test
    void closingTheWindowClosesItsPlots() {
        window.add("one");
        plotPose();
        Window plot = window.awaitShowing("plot", JFrame.class);
        window.run(window.frame::dispose);
        assertThat(plot.isDisplayable()).isFalse();
    }

    @Test
    void itsPartsHaveNamesAndReadableTexts() {
        window.add("one");
        plotPose();
        Container root = window.awaitShowing("plot", JFrame.class);
        window.run(() -> {
            assertThat(WindowAudit.nameless(root)).isEmpty();
            assertThat(WindowAudit.pale(root, Contrast.TEXT)).isEmpty();
        });
    }
}
