package majic.gui.drive;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import javax.swing.SwingUtilities;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.environment.Settings;
import majic.gui.ToyBot;
import majic.gui.ToyType;
import majic.gui.WindowWait;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majic.time.TimeSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests driving by a game controller that is a double. */
class GamepadControlTest {
    private static final GamepadState RELEASED = GamepadState.of(false, 1, 0);
    private static final GamepadState AHEAD = GamepadState.of(true, 1, 0);

    private final AtomicReference<GamepadState> state = new AtomicReference<>(RELEASED);
    private final AtomicBoolean closed = new AtomicBoolean();
    private final AtomicInteger reads = new AtomicInteger();
    private final List<String> problems = new CopyOnWriteArrayList<>();
    private final Team team = new Team(TimeSource.system());
    private final GamepadControl control =
            new GamepadControl(Fake::new, new GuardChoice(Settings.inMemory()), problems::add, problems::add);
    private ToyBot bot;

    private final class Fake implements Gamepad {
        private boolean wasRead;

        @Override
        public GamepadState read() {
            wasRead = true;
            reads.incrementAndGet();
            return state.get();
        }

        @Override
        public void close() {
            closed.set(wasRead);
        }
    }

    @BeforeEach
    void switchOn() throws Exception {
        BotFactory factory = new BotFactory(List.of(new ToyType(BotType.Reach.TCP)), Settings.inMemory());
        bot = (ToyBot) factory.create("toy://one");
        bot.connect();
        Member member = team.add(bot, OptionalInt.empty());
        SwingUtilities.invokeAndWait(() -> {
            control.choose(List.of(member));
            control.switchOn();
        });
    }

    @AfterEach
    void close() throws Exception {
        SwingUtilities.invokeAndWait(control::close);
        team.close();
    }

    private static void await(String what, BooleanSupplier condition) {
        WindowWait.await(what, condition);
    }

    /** Shows a state to the control, and waits until it has been read twice more. */
    private void awaitState(GamepadState newState) {
        state.set(newState);
        int before = reads.get();
        await("the state", () -> reads.get() >= before + 3);
    }

    private void drive() {
        awaitState(RELEASED);
        state.set(AHEAD);
        await("the drive", () -> bot.told.stream().anyMatch(order -> order.startsWith("drive ")));
    }

    @Test
    void theStickDrivesWhileTheButtonIsHeld() {
        drive();
        await(
                "renewals",
                () -> bot.told.stream()
                                .filter(order -> order.startsWith("drive "))
                                .count()
                        >= 3);
        assertThat(bot.told).doesNotContain("halt");
    }

    @Test
    void releasingTheButtonStopsTheRobot() {
        drive();
        state.set(RELEASED);
        await("the stop", () -> bot.told.contains("halt"));
    }

    @Test
    void unpluggingTheControllerStopsTheRobot() {
        drive();
        state.set(GamepadState.UNPLUGGED);
        await("the stop", () -> bot.told.contains("halt"));
    }

    @Test
    void afterPluggingInTheButtonMustBeReleasedOnce() {
        awaitState(GamepadState.UNPLUGGED);
        awaitState(AHEAD);
        assertThat(bot.told).noneMatch(order -> order.startsWith("drive "));
    }

    @Test
    void stopEndsTheDriveThoughTheButtonIsStillHeld() {
        drive();
        team.stopAll();
        await("the stop", () -> bot.told.contains("halt"));
        long drives =
                bot.told.stream().filter(order -> order.startsWith("drive ")).count();
        awaitState(AHEAD);
        assertThat(bot.told.stream().filter(order -> order.startsWith("drive ")))
                .hasSize((int) drives);
    }

    @Test
    void anotherChoiceOfRobotsStopsTheOnesBefore() throws Exception {
        drive();
        SwingUtilities.invokeAndWait(() -> control.choose(List.of()));
        await("the stop", () -> bot.told.contains("halt"));
    }

    @Test
    void switchingOffStopsTheRobotAndClosesTheController() throws Exception {
        drive();
        SwingUtilities.invokeAndWait(control::switchOff);
        await("the stop", () -> bot.told.contains("halt"));
        await("the end", closed::get);
        assertThat(control.isOn()).isFalse();
    }

    @Test
    void aStickNearItsMiddleDrivesNothing() {
        assertThat(GamepadState.of(true, 0.1, -0.1).drives()).isFalse();
        assertThat(GamepadState.of(true, 1, 0).forward()).isEqualTo(1);
    }

    @Test
    void withoutNativeCodeItSwitchesOffAndGivesTheReason() throws Exception {
        GamepadControl without = new GamepadControl(
                () -> {
                    throw new BotException("Game controllers cannot be read on this computer (none)");
                },
                new GuardChoice(Settings.inMemory()),
                problems::add,
                problems::add);
        SwingUtilities.invokeAndWait(without::switchOn);
        await("the reason", () -> problems.contains("Game controllers cannot be read on this computer (none)"));
        assertThat(without.isOn()).isFalse();
    }
}
