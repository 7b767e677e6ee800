package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import majic.bot.BotException;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.bot.Value;
import majic.gui.WindowWait;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;
import majic.inlab.LaidOutPanel;
import majic.panel.CommandHost;
import majic.panel.RefreshingPanel;
import majic.panel.StatusLight;
import majic.script.MajicParser;
import majic.text.MarkedTexts;
import majic.time.WaitLimit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The panel of the simulated rover and copter: laid out without a display, and in a window where it is operated. */
class MavlinkPanelInLabTest {
    /** Values, and the words of the autopilot. */
    private static final Pattern DATA = Pattern.compile("\\b(mm/s|mm|clear|rover 4\\.6\\.0)\\b");

    @BeforeEach
    void lookAsInTheProgram() throws Exception {
        LaidOutPanel.lookAsInTheProgram();
    }

    private static List<String> messages(LaidOutPanel panel) {
        JList<?> list = panel.visible(JList.class).get(0);
        return IntStream.range(0, list.getModel().getSize())
                .mapToObj(row -> list.getModel().getElementAt(row).toString())
                .toList();
    }

    private static List<String> buttons(LaidOutPanel panel) {
        return panel.visible(JButton.class).stream()
                .map(Component::getName)
                .filter(List.of("hold", "land", "surface", "home", "arm", "disarm")::contains)
                .toList();
    }

    @Test
    void thePanelShowsWhatTheRoverReports() throws Exception {
        try (LabRig lab = LabRig.exactWithMavlink("rover+ready")) {
            MajicBot bot = lab.add("mavlink");
            lab.run("1 arm", "1 move 300", "wait 3s");
            LaidOutPanel panel = LaidOutPanel.of(bot, 900, 600);

            assertThat(panel.text("x")).isEqualTo(bot.get("x").toString());
            assertThat(panel.text("altitude")).endsWith("mm");
            assertThat(panel.text("groundSpeed")).endsWith("mm/s");
            assertThat(panel.text("model")).startsWith("rover 4");
            assertThat(panel.text("armed")).isEqualTo("ARMED");
            assertThat(panel.text("satellites")).matches("3-D, \\d+ satellites");
            assertThat(panel.text("battery")).contains("V", "%");
            assertThat(panel.text("link")).isEqualTo("link ok");
            assertThat(buttons(panel)).containsExactly("hold", "arm", "disarm");
            assertThat(messages(panel)).contains("Throttle armed");
        }
    }

    @Test
    void theReasonsOfARefusalAreAmongTheMessages() throws Exception {
        try (LabRobot robot = new LabRobot("mavlink", LabRig.exactWithMavlink("rover")).at(1200, 0, 0)) {
            robot.bot().connect();
            assertThatThrownBy(() -> robot.bot().run("arm", List.of())).isInstanceOf(BotException.class);

            assertThat(messages(LaidOutPanel.of(robot.bot(), 900, 600))).anyMatch(text -> text.startsWith("Arm: "));
            assertThat(((MajicMavlink) robot.bot()).texts())
                    .anyMatch(text -> text.text().startsWith("Arm: ") && text.isWarning());
        }
    }

    @Test
    void aLostVehicleIsShownGreyWithItsLastReadings() throws Exception {
        try (LabRobot robot = new LabRobot("mavlink", LabRig.exactWithMavlink("rover+ready")).at(1200, 0, 0)) {
            robot.bot().connect();
            robot.bot().time().sleep(2);
            assertThat(LaidOutPanel.of(robot.bot(), 900, 600)
                            .label("groundSpeed")
                            .isEnabled())
                    .isTrue();

            robot.cut();
            while (robot.bot().isConnected()) {
                robot.bot().time().sleep(0.1);
            }
            LaidOutPanel panel = LaidOutPanel.of(robot.bot(), 900, 600);
            assertThat(panel.text("link")).isEqualTo("link lost");
            assertThat(panel.label("groundSpeed").isEnabled()).isFalse();
            assertThat(panel.label("armed").isEnabled()).isFalse();
            assertThat(panel.text("groundSpeed")).endsWith("mm/s");
        }
    }

    @Test
    void aFailsafeThatATextAnnouncesIsShownUntilAHeartbeatDeniesIt() throws Exception {
        try (LabRig lab = LabRig.exactWithMavlink("rover+ready")) {
            MajicBot bot = lab.add("mavlink");
            lab.run("wait 2s");
            assertThat(LaidOutPanel.of(bot, 900, 600).text("failsafe")).isEqualTo("no failsafe");

            lab.lab().simulators().besideMavlink("mavlink", rover -> rover.say(4, "Battery Failsafe"));
            lab.lab().time().sleep(0.01);
            StatusLight light = (StatusLight) LaidOutPanel.of(bot, 900, 600).label("failsafe");
            assertThat(light.getText()).isEqualTo("FAILSAFE");
            assertThat(light.kind()).isEqualTo(StatusLight.Kind.ALARM);
            assertThat(light.getAccessibleContext().getAccessibleName()).isEqualTo("FAILSAFE");

            lab.run("wait 2s");
            assertThat(LaidOutPanel.of(bot, 900, 600).text("failsafe")).isEqualTo("no failsafe");
        }
    }

    @Test
    void aCopterHasButtonsToLandAndToReturn() throws Exception {
        try (LabRig lab = LabRig.exactWithMavlink("copter+ready")) {
            LaidOutPanel panel = LaidOutPanel.of(lab.add("mavlink"), 900, 600);
            assertThat(buttons(panel)).contains("hold", "land", "home");
        }
    }

    @Test
    void theButtonsAndTheMenuOfModesSubmitCommands() throws Exception {
        try (LabRig lab = LabRig.exactWithMavlink("rover+ready")) {
            MajicBot bot = lab.add("mavlink");
            Window window = Window.open(bot, lab);
            try {
                window.click("arm");
                lab.await(() -> bot.get("armed").equals(Value.yesNo(true)));
                window.choose("STEERING");
                lab.await(() -> bot.get("mode").toString().equals("STEERING"));
                window.click("hold");
                lab.await(() -> bot.get("mode").toString().equals("HOLD"));
                window.click("disarm");
                lab.await(() -> bot.get("armed").equals(Value.yesNo(false)));
                assertThat(window.commands).containsExactly("arm", "set mode STEERING", "hold", "disarm");
            } finally {
                window.close();
            }
        }
    }

    @Test
    void theMenuOfACopterHasOnlyTheModesThatAreAccepted() throws Exception {
        try (LabRig lab = LabRig.exactWithMavlink("copter+ready")) {
            MajicBot bot = lab.add("mavlink");
            Window window = Window.open(bot, lab);
            try {
                assertThat(window.modes()).contains("BRAKE", "LAND", "RTL").doesNotContain("AUTO", "STABILIZE");
                window.choose("LAND");
                lab.await(() -> bot.get("mode").toString().equals("LAND"));
            } finally {
                window.close();
            }
        }
    }

    @Test
    void everyControlCanBeReachedByKeysAndExplainsItself() throws Exception {
        try (LabRig lab = LabRig.exactWithMavlink("copter+ready")) {
            Window window = Window.open(lab.add("mavlink"), lab);
            try {
                for (String name : List.of("mode", "hold", "land", "home")) {
                    AbstractButton button = window.button(name);
                    assertThat(button.isEnabled() && button.isFocusable())
                            .as(name)
                            .isTrue();
                    assertThat(button.getToolTipText()).as(name).contains("In commands: ");
                    assertThat(button.getAccessibleContext().getAccessibleName())
                            .as(name)
                            .isNotBlank();
                }
            } finally {
                window.close();
            }
        }
    }

    @Test
    void aReplayShowsTheTextsOfThePanelAndHasNoButtons() throws Exception {
        try (LabRig lab = LabRig.exactWithMavlink("rover+ready")) {
            MajicBot bot = lab.add("mavlink");
            lab.run("1 arm", "wait 3s");
            Map<String, String> state = bot.displayState();
            LaidOutPanel live = LaidOutPanel.of(bot, 900, 600);

            LaidOutPanel replayed = LaidOutPanel.of(() -> replay(bot, state), 900, 600);
            for (String name : List.of("satellites", "armed", "failsafe", "battery", "altitude")) {
                assertThat(replayed.text(name)).as(name).isEqualTo(live.text(name));
            }
            assertThat(messages(replayed)).isNotEmpty().isEqualTo(messages(live));
        }
    }

    private static JComponent replay(MajicBot bot, Map<String, String> state) {
        ReplayDisplay replay = new MavlinkType().replay(bot);
        replay.show(state, bot.time().nanos());
        RefreshingPanel panel = (RefreshingPanel) replay.component();
        panel.addNotify();
        panel.refreshIfChanged();
        panel.removeNotify();
        return panel;
    }

    @ParameterizedTest
    @CsvSource({"346, 300", "460, 320", "540, 350", "800, 600", "400, 700", "1000, 800"})
    void nothingIsCutOffOrCovered(int width, int height) throws Exception {
        try (LabRig lab = LabRig.exactWithMavlink("copter+ready")) {
            LaidOutPanel panel = LaidOutPanel.of(lab.add("mavlink"), width, height);
            panel.checkThatNothingIsCovered();
            panel.checkThatNoTextIsCut(1);
        }
    }

    @Test
    void everyPartHasANameAndEnoughContrastInBothLooks() throws Exception {
        try (LabRig lab = LabRig.exactWithMavlink("rover+ready")) {
            LaidOutPanel.checkNamesAndContrast(List.of(lab.add("mavlink")), 900, 600);
        }
    }

    @Test
    @SuppressWarnings("try")
    void everyTextIsFromAResourceBundle() throws Exception {
        Locale before = Locale.getDefault();
        try (MarkedTexts marked = new MarkedTexts();
                LabRig lab = LabRig.exactWithMavlink("rover+ready")) {
            Locale.setDefault(marked.language());
            assertThat(LaidOutPanel.of(lab.add("mavlink"), 900, 600).unmarked(DATA))
                    .isEmpty();
        } finally {
            Locale.setDefault(before);
        }
    }

    /** A real window with a panel whose controls submit lines to the session of the lab. */
    private static final class Window extends JPanel implements CommandHost {
        private static final long serialVersionUID = 1;
        private final transient MajicParser parser;
        private final transient List<String> commands = new CopyOnWriteArrayList<>();
        private final JFrame frame = new JFrame("panel");

        private Window(MajicBot bot, LabRig lab) {
            super(new BorderLayout());
            parser = MajicParser.prompt(lab.session());
            add(Objects.requireNonNull(bot.display()));
            frame.setContentPane(this);
            frame.setSize(900, 600);
            frame.setVisible(true);
        }

        static Window open(MajicBot bot, LabRig lab) throws Exception {
            Window[] opened = new Window[1];
            SwingUtilities.invokeAndWait(() -> opened[0] = new Window(bot, lab));
            WindowWait.await("the buttons", () -> find(opened[0], "hold") instanceof JButton hold && hold.isEnabled());
            return opened[0];
        }

        /** As the window does: nothing waits on the event dispatch thread. */
        @Override
        public void submitCommand(String command) {
            commands.add(command);
            CompletableFuture.runAsync(() -> parser.parseText("1 " + command));
        }

        AbstractButton button(String name) {
            return (AbstractButton) Objects.requireNonNull(find(this, name), name);
        }

        void click(String name) throws Exception {
            SwingUtilities.invokeAndWait(() -> button(name).doClick());
        }

        void choose(String mode) throws Exception {
            SwingUtilities.invokeAndWait(() -> {
                button("mode").doClick();
                ((AbstractButton) Objects.requireNonNull(find(menu(), "mode " + mode))).doClick();
                MenuSelectionManager.defaultManager().clearSelectedPath();
            });
        }

        List<String> modes() throws Exception {
            CompletableFuture<List<String>> modes = new CompletableFuture<>();
            SwingUtilities.invokeAndWait(() -> {
                button("mode").doClick();
                modes.complete(List.of(menu().getComponents()).stream()
                        .map(item -> ((AbstractButton) item).getText())
                        .toList());
                MenuSelectionManager.defaultManager().clearSelectedPath();
            });
            return WaitLimit.join("the modes", modes);
        }

        private static JPopupMenu menu() {
            return (JPopupMenu)
                    MenuSelectionManager.defaultManager().getSelectedPath()[0].getComponent();
        }

        private static Component find(Container parent, String name) {
            for (Component child : parent.getComponents()) {
                Component found = name.equals(child.getName())
                        ? child
                        : child instanceof Container inner ? find(inner, name) : null;
                if (found != null) {
                    return found;
                }
            }
            return null;
        }

        void close() throws Exception {
            SwingUtilities.invokeAndWait(frame::dispose);
        }
    }
}
