package majic.gui.add;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import javax.swing.JList;
import javax.swing.JProgressBar;
import javax.swing.SwingUtilities;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.gui.TestWindow;
import majic.gui.ToyType;
import majic.gui.kit.ProgramServices.SerialPortChoice;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class SearchDialogWindowTest {
    private static final InetAddress HERE = InetAddress.getLoopbackAddress();

    @AutoClose
    private final TestWindow window = TestWindow.open();

    @AutoClose
    private final ServerSocket robot = new ServerSocket(0, 5, HERE);

    private final CompletableFuture<String> chosen = new CompletableFuture<>();

    SearchDialogWindowTest() throws IOException {}

    private void search(BotType type, Set<InetSocketAddress> spared) {
        search(type, () -> List.of(HERE), spared);
    }

    private void search(BotType type, Supplier<List<InetAddress>> hosts, Set<InetSocketAddress> spared) {
        search(type, new SearchDialog.Places(hosts, () -> spared, () -> List.of(new SerialPortChoice("COM9", "COM9"))));
    }

    private void search(BotType type, SearchDialog.Places places) {
        window.run(() -> new SearchDialog(window.frame(), List.of(type), places, chosen::complete).setVisible(true));
    }

    private ToyType listening(BotType.Reach... reaches) {
        return new ToyType(reaches).at(robot.getLocalPort());
    }

    private JList<?> list() {
        return window.find("foundRobots", JList.class);
    }

    private void awaitEnd() {
        window.await(
                "the end of the search",
                () -> !window.text("searchStatus").startsWith("Trying")
                        && !window.text("searchStatus").startsWith("Looking"));
    }

    @Test
    void aRobotThatWasFoundCanBeChosen() {
        search(listening(BotType.Reach.TCP), Set.of());
        window.await("the robot", () -> list().getModel().getSize() == 1);
        window.run(() -> list().setSelectedIndex(0));
        window.push("Use");

        assertThat(chosen).isCompletedWithValue("toy://127.0.0.1:" + robot.getLocalPort());
    }

    @Test
    void theSerialPortsOfThisComputerAreListed() {
        search(listening(BotType.Reach.SERIAL), Set.of(new InetSocketAddress(HERE, robot.getLocalPort())));
        window.await("the port", () -> list().getModel().getSize() == 1);
        window.run(() -> list().setSelectedIndex(0));
        window.push("Use");

        assertThat(chosen).isCompletedWithValue("toy:COM9");
    }

    @Test
    void robotsThatSendToThisComputerAreListed() {
        search(
                listening(BotType.Reach.TCP),
                new SearchDialog.Places(
                        List::of, Set::of, List::of, type -> Map.of("toy:udp://:14550?system=3", "rover")));
        window.await("the robot", () -> list().getModel().getSize() == 1);
        window.run(() -> list().setSelectedIndex(0));
        window.push("Use");

        assertThat(chosen).isCompletedWithValue("toy:udp://:14550?system=3");
    }

    @Test
    void aTextThatIsThereFromTheBeginningDoesNotMakeTheDialogHigh() {
        search(listening(BotType.Reach.SERIAL), Set.of());
        assertThat(SwingUtilities.getWindowAncestor(list()).getHeight()).isLessThan(500);
    }

    @Test
    void theRobotsOfTheTeamAreSpared() {
        search(listening(BotType.Reach.TCP), Set.of(new InetSocketAddress(HERE, robot.getLocalPort())));
        awaitEnd();

        assertThat(list().getModel().getSize()).isZero();
        assertThat(window.text("searchStatus")).startsWith("Nothing answers");
    }

    @Test
    void withoutANetworkOnlyTheSerialPortsAreListed() {
        search(listening(BotType.Reach.SERIAL, BotType.Reach.TCP), List::of, Set.of());
        awaitEnd();

        assertThat(window.text("searchStatus"))
                .isEqualTo("This computer is in no network; only its serial ports are listed.");
        assertThat(list().getModel().getSize()).isOne();
        assertThat(isProgressing()).isFalse();
    }

    @Test
    void aSearchThatFailsShowsTheReasonAndNoProgress() {
        search(
                listening(BotType.Reach.TCP),
                () -> {
                    throw new BotException("The networks cannot be read");
                },
                Set.of());
        awaitEnd();

        assertThat(window.text("searchStatus")).isEqualTo("The networks cannot be read");
        assertThat(isProgressing()).isFalse();
    }

    private boolean isProgressing() {
        JProgressBar progress = window.find("searchProgress", JProgressBar.class);
        return progress.isIndeterminate() || progress.getPercentComplete() < 1;
    }

    @Test
    void theNetworkIsSearchedAlsoIfTheSerialPortsCannotBeListed() {
        search(listening(BotType.Reach.TCP), new SearchDialog.Places(() -> List.of(HERE), Set::of, () -> {
            throw new BotException("No folder allows execution.");
        }));

        window.await("the robot", () -> list().getModel().getSize() == 1);
        window.await("the reason", () -> window.text("searchStatus").endsWith("No folder allows execution."));
    }
}
