package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.BooleanSupplier;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import majic.bot.BotAddress;
import majic.gui.WindowWait;
import majic.gui.kit.EventThreadChecks;
import majic.panel.PictureView;
import majic.team.Member;
import majic.team.Owner;
import majic.team.Team;
import majic.team.TeamListener;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The panel on a tab of a real window, before a scripted dog. */
class AiboPanelWindowTest {
    private static final String ASKED = "camera.val";

    @AutoClose
    private final EventThreadChecks checks = new EventThreadChecks();

    private final Team team = new Team(TimeSource.system());
    private final BlockingQueue<String> notices = new LinkedBlockingQueue<>();
    private ScriptedDog dog;
    private Member member;
    private JFrame frame;
    private JTabbedPane tabs;

    @BeforeEach
    void open() throws Exception {
        dog = ScriptedDog.inRealTime();
        dog.set(ASKED, "BIN 12 YCbCr 2 2\nabcdefghijkl");
        MajicAibo aibo = new MajicAibo(new BotAddress("aibo", dog.address()), dog.environment());
        aibo.connect();
        member = team.add(aibo, OptionalInt.empty());
        team.addListener(new TeamListener() {
            @Override
            public void noticed(int robot, String text) {
                notices.add(text);
            }
        });
        SwingUtilities.invokeAndWait(() -> {
            JComponent panel = Objects.requireNonNull(aibo.display());
            tabs = new JTabbedPane();
            tabs.addTab("1", panel);
            tabs.addTab("2", new JPanel());
            frame = new JFrame();
            frame.add(tabs);
            frame.setSize(700, 450);
            frame.setVisible(true);
        });
        checks.windowIsOpen();
    }

    @AfterEach
    void close() throws Exception {
        SwingUtilities.invokeAndWait(frame::dispose);
        team.close();
        dog.close();
    }

    @Test
    void theCameraIsOffWhileAnotherTabIsShown() throws Exception {
        await(
                "a picture",
                () -> view().getAccessibleContext().getAccessibleName().endsWith("frames/s"));
        select(1);
        await("the last words", this::stopped);
        int asked = dog.received(ASKED).size();
        int polled = dog.received().size();
        await("the driver's pings", () -> dog.received().size() > polled + 3);
        assertThat(dog.received(ASKED)).hasSize(asked);

        select(0);
        await("another picture", () -> dog.received(ASKED).size() > asked);
    }

    @Test
    void dataThatIsNoPictureIsReportedInItsPlace() {
        dog.set(ASKED, "BIN 5 jpeg 208 160\nabcde");

        await("words", () -> view().getAccessibleContext().getAccessibleName().contains("neither JPEG nor PNG"));
    }

    @Test
    void aSliderTurnsTheHeadAndReportsThatTheMotorsAreSwitchedOn() throws Exception {
        drag("headPan", 30);

        dog.awaitReceived("headPan.val = 30");
        assertThat(notices.take()).isEqualTo("1: switches the dog's motors on");
        await("the hand to be off", () -> member.owner() == null);
    }

    @Test
    void aSliderIsRefusedAndReturnsWhileAnActOwnsTheDog() throws Exception {
        member.claim(new Owner(Owner.Kind.ACT, "WanderDog", () -> {}));
        drag("headPan", 30);

        assertThat(notices.take()).contains("is running WanderDog");
        await("the knob to go back", () -> slider("headPan").getValue() == 0);
        assertThat(dog.received("headPan.val =")).isEmpty();
    }

    @Test
    void aSliderIsRefusedWhileStopIsLatched() throws Exception {
        team.stopAll();
        await("the stop", () -> member.isIdle());
        drag("neck", -30);

        assertThat(notices.take()).contains("STOP is latched");
        assertThat(dog.received("neck.val =")).isEmpty();
    }

    @Test
    void theKnobFollowsTheJoint() {
        dog.set("headTilt.val", "20.400000");

        await("the knob", () -> slider("headTilt").getValue() == 20);
    }

    private boolean stopped() {
        return dog.received().stream()
                .filter(command -> command.contains("ledF1.val"))
                .map(command -> "stop " + command.substring(0, command.indexOf(':')))
                .anyMatch(stop -> dog.received().contains(stop));
    }

    private void drag(String joint, int degrees) throws Exception {
        await("a usable slider", () -> slider(joint).isEnabled());
        SwingUtilities.invokeAndWait(() -> slider(joint).setValue(degrees));
    }

    private void select(int tab) throws Exception {
        SwingUtilities.invokeAndWait(() -> tabs.setSelectedIndex(tab));
    }

    private PictureView view() {
        return (PictureView) Objects.requireNonNull(find(frame, "camera"));
    }

    private JSlider slider(String joint) {
        return (JSlider) Objects.requireNonNull(find(frame, "slider " + joint));
    }

    private static @Nullable Component find(Container parent, String name) {
        for (Component child : parent.getComponents()) {
            Component found =
                    name.equals(child.getName()) ? child : child instanceof Container inner ? find(inner, name) : null;
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    private static void await(String what, BooleanSupplier condition) {
        WindowWait.await(what, condition);
    }
}
