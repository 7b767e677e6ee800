package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Dialog;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.ListModel;
import javax.swing.RootPaneContainer;
import javax.swing.text.JTextComponent;
import majic.act.NoActs;
import majic.act.file.ActCatalog;
import majic.bot.BotType;
import majic.environment.Settings;
import majic.gui.kit.EventThreadChecks;
import majic.gui.kit.ProgramServices;
import majic.lab.LabAccess;
import majic.log.SessionLog;
import majic.recorder.RecordingFolder;
import majic.script.MajicParser;
import majic.script.Session;
import majic.team.BotFactory;
import majic.team.Team;
import majic.text.MarkedTexts;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.assertj.swing.core.BasicRobot;
import org.assertj.swing.core.ComponentFinder;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.core.Robot;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.jspecify.annotations.Nullable;

/**
 * Opens a real window with toy robots, and operates it. The only class that uses the library for window tests. Without
 * a display it cannot be opened, and the test fails. Using Swing off its thread, and keeping that thread busy for a
 * second, fail the test too, and so does a component that interprets HTML.
 */
public final class TestWindow implements AutoCloseable {
    private static final String MARKED = "test.marked";
    /** So many robots are added before the window has shown them: each tab is an event of its own. */
    private static final int AT_ONCE = 20;

    public final ToyType type = new ToyType(BotType.Reach.TCP);
    public final Settings settings = Settings.inMemory();
    public final BotFactory factory = new BotFactory(List.of(type), settings);
    public final Team team = new Team(TimeSource.system(), 200);
    public final FakeSharing sharing = new FakeSharing();
    public final AtomicInteger quits = new AtomicInteger();
    public final Session session;
    public final MajicParser parser;
    public final MajicFrame frame;
    private final @Nullable Path history;
    private final Robot robot;
    private final java.awt.Robot input = input();
    private final ArrivedInput arrived = ArrivedInput.count();
    private final EventThreadChecks checks = new EventThreadChecks();

    private TestWindow(ActCatalog acts, Map<String, String> kept, @Nullable Path history) {
        this.history = history;
        settings.put("robots.reconnect", "off");
        kept.forEach(settings::put);
        session = new Session(team, factory, SessionLog.none(), acts, quits::incrementAndGet);
        parser = MajicParser.prompt(session);
        robot = robot();
        try {
            frame = GuiActionRunner.execute(this::makeFrame);
            show();
        } catch (RuntimeException | Error e) {
            closeAfter(e);
            throw e;
        }
    }

    private void show() {
        robot.showWindow(frame);
        await("the keys", frame::isFocused);
        await("the menus to have entries", () -> frame.getJMenuBar().getMenu(0).getItemCount() > 0);
        settle();
        checks.windowIsOpen();
    }

    /** Leaves nothing behind that could disturb the next test. */
    private void closeAfter(Throwable failure) {
        try {
            release();
        } catch (RuntimeException | Error e) {
            failure.addSuppressed(e);
        }
    }

    private static Robot robot() {
        Robot made = BasicRobot.robotWithNewAwtHierarchyWithoutScreenLock();
        made.settings().delayBetweenEvents(0);
        made.settings().eventPostingDelay(0);
        made.settings().timeoutToBeVisible(WaitLimit.MS);
        made.settings().timeoutToFindPopup(WaitLimit.MS);
        made.settings().idleTimeout(WaitLimit.MS);
        return made;
    }

    private static java.awt.Robot input() {
        try {
            return new java.awt.Robot();
        } catch (AWTException e) {
            throw new IllegalStateException("the display takes no input", e);
        }
    }

    /**
     * Waits until the window system has delivered all input and Swing has handled it, with all that follows from it.
     * The library would wait for a fixed time instead.
     */
    private void settle() {
        input.waitForIdle();
    }

    /** Gives input, and waits until that many events of it have arrived and Swing has handled them. */
    private void give(int event, int count, Runnable input) {
        int wanted = arrived.count(event) + count;
        input.run();
        await("the input", () -> arrived.count(event) >= wanted);
        settle();
    }

    public static TestWindow open() {
        return new TestWindow(NoActs.here(), Map.of(), null);
    }

    /** Opens a window with a setting from an earlier start. */
    public static TestWindow openWith(String key, String value) {
        return new TestWindow(NoActs.here(), Map.of(key, value), null);
    }

    /** Opens a window with the user's own acts. */
    public static TestWindow open(ActCatalog acts) {
        return new TestWindow(acts, Map.of(), null);
    }

    /** Opens a window that keeps the typed lines in a file. */
    public static TestWindow withHistory(Path history) {
        return new TestWindow(NoActs.here(), Map.of(), history);
    }

    /** Opens a window whose texts are marked, with the user's own acts. */
    public static TestWindow openMarked(ActCatalog acts) {
        return new TestWindow(acts, Map.of(MARKED, ""), null);
    }

    private MajicFrame makeFrame() {
        MajicFrame.installLook(settings);
        settings.get(MARKED).ifPresent(marked -> Language.use(MarkedTexts.LANGUAGE));
        ProgramServices services = new ProgramServices(
                List::of,
                () -> factory.useLab(new ToyLab()),
                this::quit,
                settings,
                new RecordingFolder(Path.of("no recordings")),
                null,
                history,
                sharing);
        return new MajicFrame(session, parser, services, 0);
    }

    private void quit() {
        quits.incrementAndGet();
    }

    public MajicFrame frame() {
        return frame;
    }

    /** Adds a connected toy and waits for its tab. */
    public ToyBot add(String address) {
        return connect("toy:" + address);
    }

    /** Adds this many connected toys, and waits for their tabs. */
    public void addAll(int robots) {
        for (int number = 1; number <= robots; number++) {
            ToyBot bot = (ToyBot) factory.create("toy:number " + number);
            bot.connect();
            team.add(bot, OptionalInt.of(number));
            if (number % AT_ONCE == 0) {
                settle();
            }
        }
        await("the tabs", () -> tabs().size() == robots);
        settle();
    }

    /** Starts a lab, and adds its robot as {@link #add} does. */
    public ToyBot addFrom(LabAccess lab) {
        factory.useLab(lab);
        return connect("sim:toy");
    }

    private ToyBot connect(String address) {
        ToyBot bot = (ToyBot) factory.create(address);
        bot.connect();
        int number = team.add(bot, OptionalInt.empty()).number();
        await("a tab for robot " + number, () -> tabs().contains("" + number));
        settle();
        return bot;
    }

    /** Returns the numbers of the robots on the tabs, in the order of the tabs. */
    public List<String> tabs() {
        JTabbedPane pane = find("mainPane", JTabbedPane.class);
        return GuiActionRunner.execute(() -> IntStream.range(0, pane.getTabCount())
                .mapToObj(pane::getTitleAt)
                .toList());
    }

    /** Returns the places of the tabs in their pane. */
    public List<Rectangle> tabPlaces() {
        JTabbedPane pane = find("mainPane", JTabbedPane.class);
        return GuiActionRunner.execute(() -> IntStream.range(0, pane.getTabCount())
                .mapToObj(pane::getBoundsAt)
                .toList());
    }

    public <T extends Component> T find(String name, Class<T> kind) {
        return search(finder -> finder.findByName(name, kind, false));
    }

    /**
     * Searches in one event of the event dispatch thread. Called on another thread, the finder would post two events
     * for each component of all windows, which takes most of the time of a window test.
     */
    private <T> T search(Function<ComponentFinder, T> search) {
        return GuiActionRunner.execute(() -> search.apply(robot.finder()));
    }

    /** Waits until a component is shown, and returns it. */
    public <T extends Component> T awaitShowing(String name, Class<T> kind) {
        await(name + " to show", () -> showing(found -> kind.isInstance(found) && name.equals(found.getName())) == 1);
        return search(finder -> finder.findByName(name, kind, true));
    }

    private int showing(Predicate<Component> wanted) {
        return search(finder -> finder.findAll(found -> wanted.test(found) && found.isShowing()))
                .size();
    }

    public Dialog awaitDialog(String title) {
        return awaitShowing(title + " dialog", Dialog.class);
    }

    public boolean isShowing(String name) {
        return showing(found -> name.equals(found.getName())) > 0;
    }

    public boolean isStopLatched() {
        return team.isLatched();
    }

    /**
     * Waits until a dialog is shown and has the keyboard focus. Requests the focus, as a click on the dialog does: a
     * window manager can leave it to another window when a previous dialog has just closed.
     */
    public void awaitDialogWithKeys(String title) {
        Dialog dialog = awaitDialog(title);
        await("the keys of " + title, () -> {
            if (!dialog.isFocused()) {
                run(() -> {
                    dialog.toFront();
                    dialog.requestFocus();
                });
            }
            return dialog.isFocused();
        });
    }

    public String text(String name) {
        Component component = find(name, Component.class);
        return GuiActionRunner.execute(() -> {
            if (component instanceof JTextComponent field) {
                return field.getText();
            }
            return component instanceof JLabel label ? label.getText() : ((AbstractButton) component).getText();
        });
    }

    public void focus(String name) {
        robot.focusAndWaitForFocusGain(find(name, Component.class));
    }

    /** As {@link #focus(String)}, for a component whose name others have too. */
    public void focus(Component component) {
        robot.focusAndWaitForFocusGain(component);
    }

    /** Types into the component that has the focus. */
    public void type(String text) {
        give(KeyEvent.KEY_TYPED, text.length(), () -> robot.enterText(text));
    }

    /** Dispatches the event of a typed character with a given time, ms since 1970. */
    public void typeAsOf(long whenMs, String name, char character) {
        Component component = find(name, Component.class);
        run(() -> component.dispatchEvent(
                new KeyEvent(component, KeyEvent.KEY_TYPED, whenMs, 0, KeyEvent.VK_UNDEFINED, character)));
    }

    /** Types a character and presses Esc before the window handles anything that follows from the character. */
    public void typeAndEsc(String name, char character) {
        Component component = find(name, Component.class);
        KeyboardFocusManager keys = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        run(() -> {
            keys.dispatchEvent(key(component, KeyEvent.KEY_TYPED, KeyEvent.VK_UNDEFINED, character));
            keys.dispatchEvent(key(component, KeyEvent.KEY_PRESSED, KeyEvent.VK_ESCAPE, (char) KeyEvent.VK_ESCAPE));
        });
    }

    private static KeyEvent key(Component component, int event, int keyCode, char character) {
        return new KeyEvent(component, event, System.currentTimeMillis(), 0, keyCode, character);
    }

    /** Types a line of commands and presses Enter. */
    public void command(String line) {
        focus("commandLine");
        type(line);
        press(KeyEvent.VK_ENTER);
    }

    public void press(int keyCode) {
        give(KeyEvent.KEY_PRESSED, 1, () -> robot.pressAndReleaseKey(keyCode));
    }

    public void pressWithCtrl(int keyCode) {
        with(KeyEvent.VK_CONTROL, () -> press(keyCode));
    }

    public void pressWithAlt(int keyCode) {
        with(KeyEvent.VK_ALT, () -> press(keyCode));
    }

    /** Dispatches the event of a key pressed together with Alt with a given time, ms since 1970. */
    public void pressWithAltAsOf(long whenMs, int keyCode) {
        run(() -> frame.dispatchEvent(new KeyEvent(
                frame, KeyEvent.KEY_PRESSED, whenMs, KeyEvent.ALT_DOWN_MASK, keyCode, KeyEvent.CHAR_UNDEFINED)));
    }

    public void clickWithCtrl(String name) {
        with(KeyEvent.VK_CONTROL, () -> click(name));
    }

    public void clickAt(String name, Point place) {
        give(MouseEvent.MOUSE_PRESSED, 1, () -> robot.click(find(name, Component.class), place));
    }

    /**
     * Dispatches the events of a double click. The display could lose the second click: the window manager holds back
     * the first one, and when it lets that go while the second one is being given, the program receives neither the
     * press nor the release of the second. Given when the first has arrived, it could be too late for a double click.
     */
    public void doubleClickAt(String name, Point place) {
        Component component = find(name, Component.class);
        run(() -> {
            for (int click = 1; click <= 2; click++) {
                component.dispatchEvent(button(component, MouseEvent.MOUSE_PRESSED, place, click));
                component.dispatchEvent(button(component, MouseEvent.MOUSE_RELEASED, place, click));
                component.dispatchEvent(button(component, MouseEvent.MOUSE_CLICKED, place, click));
            }
        });
    }

    private static MouseEvent button(Component component, int event, Point place, int click) {
        int modifiers = event == MouseEvent.MOUSE_PRESSED ? MouseEvent.BUTTON1_DOWN_MASK : 0;
        long whenMs = System.currentTimeMillis();
        return new MouseEvent(component, event, whenMs, modifiers, place.x, place.y, click, false, MouseEvent.BUTTON1);
    }

    /** Opens the context menu of a component. */
    public void menuOf(String name) {
        give(MouseEvent.MOUSE_PRESSED, 1, () -> robot.rightClick(awaitShowing(name, Component.class)));
    }

    public void menuAt(String name, Point place) {
        Component component = find(name, Component.class);
        give(MouseEvent.MOUSE_PRESSED, 1, () -> robot.click(component, place, MouseButton.RIGHT_BUTTON, 1));
    }

    /** Returns the tool tip of a place in a component. */
    public @Nullable String tipAt(String name, Point place) {
        JComponent component = find(name, JComponent.class);
        return GuiActionRunner.execute(() -> component.getToolTipText(
                new MouseEvent(component, MouseEvent.MOUSE_MOVED, 0, 0, place.x, place.y, 0, false)));
    }

    private void with(int modifier, Runnable action) {
        robot.pressKey(modifier);
        action.run();
        robot.releaseKey(modifier);
        settle();
    }

    public void hold(int keyCode) {
        give(KeyEvent.KEY_PRESSED, 1, () -> robot.pressKey(keyCode));
    }

    public void letGo(int keyCode) {
        robot.releaseKey(keyCode);
        settle();
    }

    public void holdMouse(String name) {
        give(MouseEvent.MOUSE_PRESSED, 1, () -> robot.pressMouse(find(name, Component.class), new Point(5, 5)));
    }

    public void letGoMouse() {
        robot.releaseMouseButtons();
        settle();
    }

    public void click(String name) {
        give(MouseEvent.MOUSE_PRESSED, 1, () -> robot.click(awaitShowing(name, Component.class)));
    }

    /** Presses a button without the mouse, which may still be moving to another place. */
    public void push(String name) {
        AbstractButton button = awaitShowing(name, AbstractButton.class);
        run(button::doClick);
    }

    /** Returns an entry of the window's menus. */
    public JMenuItem entry(String text) {
        JMenuBar bar = frame.getJMenuBar();
        return IntStream.range(0, bar.getMenuCount())
                .mapToObj(bar::getMenu)
                .flatMap(menu -> Stream.of(menu.getMenuComponents()))
                .filter(entry ->
                        entry instanceof JMenuItem item && item.getText().equals(text))
                .map(JMenuItem.class::cast)
                .findFirst()
                .orElseThrow();
    }

    /**
     * Gives the window a size, and waits until it is laid out with that. A late answer of the window manager to an
     * earlier request can take the size back, so it is requested until the window has it.
     */
    public void resize(int width, int height) {
        Dimension wanted = new Dimension(width, height);
        await("a window of " + width + " by " + height, () -> {
            run(() -> frame.setSize(wanted));
            return GuiActionRunner.execute(() -> frame.getSize().equals(wanted)
                    && frame.getRootPane().getWidth() == width - frame.getInsets().left - frame.getInsets().right);
        });
    }

    /** Runs an action on the event dispatch thread. */
    public void run(Runnable action) {
        GuiActionRunner.execute(action::run);
        settle();
    }

    /** Selects the item with this text in a list, once the list contains it. */
    public void select(String list, String item) {
        ListModel<?> model = awaitShowing(list, JList.class).getModel();
        await(item + " in the list", () -> indexOf(model, item) >= 0);
        run(() -> find(list, JList.class).setSelectedIndex(indexOf(model, item)));
    }

    private static int indexOf(ListModel<?> model, String item) {
        return IntStream.range(0, model.getSize())
                .filter(index -> model.getElementAt(index).toString().equals(item))
                .findFirst()
                .orElse(-1);
    }

    public void write(String field, String text) {
        JTextField component = awaitShowing(field, JTextField.class);
        run(() -> {
            component.setText(text);
            component.postActionEvent();
        });
    }

    /** Chooses a file in the file chooser once it is shown, and presses its button. */
    public void chooseFile(Path file) {
        JFileChooserFixture chooser = fileChooser();
        chooser.fileNameTextBox().setText(file.toString());
        give(MouseEvent.MOUSE_PRESSED, 1, chooser::approve);
    }

    private JFileChooserFixture fileChooser() {
        return new JFileChooserFixture(robot, awaitShowing("files", JFileChooser.class));
    }

    /** Returns the name in the file chooser. */
    public String fileName() {
        return fileNameField().getText();
    }

    /** Returns the selected part of the name in the file chooser; empty if none is selected. */
    public String selectedFileName() {
        String selected = fileNameField().getSelectedText();
        return selected == null ? "" : selected;
    }

    private JTextComponent fileNameField() {
        return fileChooser().fileNameTextBox().target();
    }

    public boolean isEnabled(String name) {
        return GuiActionRunner.execute(find(name, Component.class)::isEnabled);
    }

    public void awaitMessage(String part) {
        await("the message \"" + part + "\"", () -> text("messages").contains(part));
    }

    /** Waits for something to become true, and fails if it does not. */
    public void await(String what, BooleanSupplier condition) {
        WindowWait.await(what, condition);
    }

    @Override
    public void close() {
        List<String> html = GuiActionRunner.execute(() -> Stream.of(Window.getWindows())
                .flatMap(window -> WindowAudit.interpretingHtml(window).stream())
                .toList());
        release();
        assertThat(html).as("components that interpret HTML").isEmpty();
    }

    private void release() {
        robot.cleanUp();
        GuiActionRunner.execute(TestWindow::emptyWindows);
        arrived.close();
        team.close();
        checks.close();
    }

    /** A later change of the look goes through all windows that have not been collected yet, closed ones included. */
    private static void emptyWindows() {
        for (Window window : Window.getWindows()) {
            if (window instanceof RootPaneContainer closed && !window.isDisplayable()) {
                closed.getRootPane().setJMenuBar(null);
                closed.getContentPane().removeAll();
            }
        }
    }
}
