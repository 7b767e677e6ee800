package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.concurrent.CountDownLatch;
import java.util.function.BooleanSupplier;
import javax.swing.JComponent;
import javax.swing.JFrame;
import majic.bot.BotAddress;
import majic.gui.WindowWait;
import majic.gui.kit.EventThreadChecks;
import majic.hemisson.panel.LedButton;
import majic.panel.Banner;
import org.assertj.swing.core.BasicRobot;
import org.assertj.swing.core.Robot;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The Hemisson's tab in a real window, clicked with a real mouse, before a peer with scripted answers. */
class HemissonPanelWindowTest {

    @AutoClose
    private final EventThreadChecks checks = new EventThreadChecks();

    private final Robot mouse = BasicRobot.robotWithNewAwtHierarchyWithoutScreenLock();
    private ScriptedHemisson peer;
    private MajicHemisson bot;
    private JFrame frame;

    @BeforeEach
    void open() throws Exception {
        peer = ScriptedHemisson.inRealTime();
        bot = new MajicHemisson(new BotAddress("hemisson", peer.address()), peer.environment());
        bot.connect();
        frame = GuiActionRunner.execute(() -> {
            JFrame made = new JFrame("Hemisson");
            JComponent panel = bot.display();
            panel.setPreferredSize(new java.awt.Dimension(700, 400));
            made.setContentPane(panel);
            return made;
        });
        mouse.showWindow(frame);
        mouse.waitForIdle();
        checks.windowIsOpen();
    }

    @AfterEach
    void close() throws Exception {
        mouse.cleanUp();
        bot.close();
        peer.close();
    }

    @Test
    void aClickSwitchesALedOnAndAnotherSwitchesItOff() {
        click("ledLeft");
        await("the LED", () -> button("ledLeft").isOn());
        assertThat(bot.get("ledLeft").isYes()).isTrue();
        assertThat(peer.commands()).contains("L,0,0,1,0");

        click("ledLeft");
        await("darkness", () -> !button("ledLeft").isOn());
        assertThat(peer.commands()).contains("L,0,0,0,0");
    }

    @Test
    void aClickSoundsTheBuzzer() {
        click("beep");

        await("the buzzer", () -> button("beep").isOn());
        assertThat(peer.commands()).contains("H,1");
    }

    @Test
    void aRefusedClickShowsTheCauseAndTheLedStaysAsItWas() {
        peer.answer('L', command -> "Unknown Command ?!");

        click("ledRight");

        await("a word", () -> banner().getText().startsWith("ledRight: the robot refused"));
        assertThat(button("ledRight").isOn()).isFalse();
    }

    @Test
    void aClickOnALostRobotShowsTheCause() throws Exception {
        peer.hangUp();
        await("the loss", () -> banner().isShowing() && banner().getText().startsWith("Not connected"));

        click("ledPgm");

        await("a word", () -> banner().isShowing() && banner().getText().startsWith("ledPgm: "));
        assertThat(GuiActionRunner.execute(() -> banner().getFont().isBold())).isFalse();
    }

    @Test
    void ofClicksFasterThanTheLineTheLastOneCounts() {
        CountDownLatch answering = new CountDownLatch(1);
        peer.answer('H', command -> {
            await("leave to answer", () -> answering.getCount() == 0);
            return "h";
        });

        clickWithoutMouse("beep", 5);
        answering.countDown();

        await("the buzzer", () -> button("beep").isOn());
        assertThat(peer.commands().stream().filter(command -> command.startsWith("H")))
                .hasSizeLessThanOrEqualTo(2)
                .last()
                .isEqualTo("H,1");
    }

    @Test
    void aVisibleTabDoesNotChangeTheShareOfThePolls() {
        await("questions", () -> peer.count("N") >= 20);
        double seen = shareOfLight();
        GuiActionRunner.execute(() -> frame.setVisible(false));
        long looks = peer.count("N");

        await("more questions", () -> peer.count("N") >= looks + 20);
        assertThat(shareOfLight()).isCloseTo(seen, within(0.1));
    }

    private double shareOfLight() {
        return (double) peer.count("O") / peer.count("N");
    }

    @Test
    void theRemedyIsShownOnlyIfTheLinkIsLostInMotion() throws Exception {
        assertThat(banner().isShowing()).isFalse();
        bot.drive(40, 0);
        await("a moving robot", () -> peer.commands().contains("D,3,3"));

        peer.hangUp();

        await("what to do", () -> banner().isShowing() && banner().getText().contains("lift it"));
        assertThat(GuiActionRunner.execute(() -> banner().getFont().isBold())).isTrue();
        bot.connect();
        await("peace", () -> !banner().isShowing());
    }

    @Test
    void aConnectionLostWhileItIsStationaryIsNoAlarm() throws Exception {
        peer.hangUp();

        await("the loss", () -> !bot.isConnected());
        GuiActionRunner.execute(() -> frame.getContentPane().repaint());
        await("the sign", () -> light("link lost"));
        await("the age", () -> banner().getText().startsWith("Not connected: all values are "));
        assertThat(GuiActionRunner.execute(() -> banner().getFont().isBold())).isFalse();
    }

    private void click(String name) {
        mouse.click(button(name));
    }

    /** Faster than any mouse. */
    private void clickWithoutMouse(String name, int times) {
        GuiActionRunner.execute(() -> {
            for (int click = 0; click < times; click++) {
                button(name).doClick(0);
            }
        });
    }

    private LedButton button(String name) {
        return mouse.finder().findByName(frame, name, LedButton.class);
    }

    private Banner banner() {
        return mouse.finder().findByName(frame, "banner", Banner.class, false);
    }

    private boolean light(String words) {
        return mouse.finder()
                .findByName(frame, "line", majic.panel.StatusLight.class)
                .getText()
                .equals(words);
    }

    private static void await(String what, BooleanSupplier condition) {
        WindowWait.await(what, condition);
    }
}
