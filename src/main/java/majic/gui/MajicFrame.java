package majic.gui;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Image;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.LayoutFocusTraversalPolicy;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Settings;
import majic.gui.bots.RobotActions;
import majic.gui.command.CommandPane;
import majic.gui.drive.GamepadControl;
import majic.gui.drive.SdlGamepad;
import majic.gui.kit.BotStatus;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.EventThread;
import majic.gui.kit.EventThreadTeamListener;
import majic.gui.kit.FileDrop;
import majic.gui.kit.IconAction;
import majic.gui.kit.Icons;
import majic.gui.kit.ProgramServices;
import majic.gui.kit.RobotSelection;
import majic.gui.kit.StopButton;
import majic.gui.plot.Plots;
import majic.gui.plot.data.LiveSource;
import majic.gui.start.StartActions;
import majic.gui.start.StartPage;
import majic.log.Line;
import majic.panel.PictureView;
import majic.panel.PictureViewer;
import majic.recorder.RecordedHistory;
import majic.recorder.Recorder;
import majic.script.ActOffer;
import majic.script.MajicParser;
import majic.script.Session;
import majic.team.Member;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/**
 * The main window: buttons and STOP above; cards of the robots, team map and panels of the selected robots side by
 * side; messages and command line below. Places its parts, and passes commands on to the team and the parser. Must be
 * used on the event dispatch thread.
 */
public final class MajicFrame extends JFrame implements PictureViewer {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(MajicFrame.class);
    private static final int ICON_SIZE = 64;

    private final transient Session session;
    private final transient MajicParser parser;
    private final transient ProgramServices services;
    private final transient StopKeys stopKeys;
    private final transient FrameDialogs dialogs;
    private final transient FrameEditor editor;
    private final transient FrameTeams teams;
    private final transient FrameLab lab;
    private final transient FrameReconnect reconnect;
    private final transient CommandChannel channel = new Channel();
    private final transient Plots plots;
    private final transient RobotSelection selection = new RobotSelection();
    private final transient GamepadControl gamepad =
            new GamepadControl(SdlGamepad::open, this::showError, this::showError);
    private final StartPage start;
    private final TeamPane team;
    private final CommandPane commands;
    private boolean quitting;

    /**
     * Creates the window, not yet visible.
     *
     * @param session the session that it shows
     * @param parser parses the lines typed here; interactive
     * @param services what the program provides
     */
    public MajicFrame(Session session, MajicParser parser, ProgramServices services) {
        super("MAJIC");
        this.session = session;
        this.parser = parser;
        this.services = services;
        commands = new CommandPane(parser, services);
        plots = new Plots(
                this,
                services.settings(),
                () -> new LiveSource(session.team(), history(services.recorder())),
                this::stopButton);
        reconnect = new FrameReconnect(session.team(), services.settings(), this::attemptsChanged);
        parser.useDefaultRobots(selection::numbers);
        dialogs = new FrameDialogs(this, session, services, selection, channel);
        editor = new FrameEditor(this, session, services, this::stopAll, dialogs);
        lab = new FrameLab(session, services, channel);
        teams = new FrameTeams(this, session, services, channel);
        RobotActions actions = new RobotActions(
                session.team(), channel, plots, dialogs::loadAct, dialogs::removeBot, reconnect.attempts());
        selection.addListener(() -> gamepad.choose(selection.members()));
        start = startPage();
        team = new TeamPane(session, selection, actions, start);
        team.map().place(session.team(), channel, member -> teams.last().keepSoon());
        stopKeys = new StopKeys(this::stopAll);
        place();
        listen();
    }

    /**
     * Installs the language and the look and feel that were chosen last; must be called before the window is created.
     *
     * @param settings the stored settings
     */
    public static void installLook(Settings settings) {
        Language.install(settings);
        LookAndFeels.install(settings);
    }

    private StartPage startPage() {
        StartActions starting = new StartActions(
                lab::canStart, lab::start, dialogs::addBot, teams::openLast, editor::chooseAndOpen, dialogs::tour);
        return new StartPage(starting, teams.last());
    }

    private void place() {
        StopPanel stop = new StopPanel(session.team(), this::stopAll);
        session.team().addListener(new EventThreadTeamListener(stop));
        StopAlarm alarm = new StopAlarm(session.team());
        session.team().addListener(new EventThreadTeamListener(alarm));
        FrameActions actions = new FrameActions(this, dialogs, editor);
        JSplitPane all = new JSplitPane(JSplitPane.VERTICAL_SPLIT, team, commands);
        all.setResizeWeight(0.75);
        JPanel content = new JPanel(new MigLayout("insets 0, gap 0, hidemode 3, wrap 1", "[grow, fill]"));
        content.add(new FrameToolbar(actions.buttons(), stop), "wmin 0");
        content.add(alarm, "wmin 0, gap 8 8 0 6");
        content.add(all, "wmin 0, hmin 0, pushy, growy, gap 8 8 0 8");
        setContentPane(content);
        FrameMenu menu = new FrameMenu(this, actions, editor);
        setJMenuBar(menu);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                EventThread.background("reading pictures", () -> complete(actions, menu));
            }
        });
        setFocusTraversalPolicy(new CommandsFirst());
        setMinimumSize(new Dimension(UIScale.scale(700), UIScale.scale(520)));
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        setSize(Math.min(UIScale.scale(1280), screen.width), Math.min(UIScale.scale(800), screen.height));
        setLocationRelativeTo(null);
        new FrameMemory(this, List.of(team, all), services.settings());
    }

    /** Adds what would have delayed the window. */
    private void complete(FrameActions actions, FrameMenu menu) {
        actions.buttons().forEach(IconAction::readPicture);
        start.readPictures();
        Image icon = Icons.now("app", ICON_SIZE);
        EventThread.later(() -> {
            setIconImage(icon);
            menu.fill();
            FileDrop.installInside(getRootPane(), editor::open);
            repaint();
        });
    }

    private void listen() {
        session.addListener(commands.messages());
        stopKeys.install();
        team.start();
        setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                quit();
            }
        });
    }

    /** Makes the STOP button of a window beside this one. */
    StopButton stopButton() {
        return new StopButton(session.team(), this::stopAll);
    }

    private void stopAll() {
        if (!session.team().stopAllIfAny()) {
            showError(TEXTS.get("noRobotToStop"));
        }
    }

    /** Opens the dialog that connects a robot (thesis, contract C3). */
    public void addBot() {
        dialogs.addBot();
    }

    /** Opens the dialog that removes a robot (thesis, contract C4); shows a message if there is none. */
    public void removeBot() {
        dialogs.removeBot();
    }

    /** Opens the dialogs that load an act onto a robot (thesis, contract C5); shows a message if there is no robot. */
    public void loadAct() {
        dialogs.loadAct();
    }

    /** Opens a window with a larger view of a robot's camera pictures. */
    @Override
    public void enlarge(PictureView view) {
        dialogs.picture(view);
    }

    /**
     * Returns a robot by its number.
     *
     * @param number its number
     * @return its driver
     * @throws BotException if there is none; the message lists those there are
     */
    public MajicBot getBot(int number) {
        return session.team().member(number).bot();
    }

    /**
     * Returns the number of robots.
     *
     * @return 0 to the size of the team
     */
    public int totalBots() {
        return session.team().members().size();
    }

    /**
     * Ends the program, in the background; has no effect when called again. Asks first what to do with scripts that are
     * not saved.
     */
    public void quit() {
        editor.closeThen(() -> {
            if (!quitting) {
                quitting = true;
                setTitle(TEXTS.get("quitting"));
                EventThread.background("quit", () -> {
                    Runnable keepTeam = teams.last().snapshot();
                    services.quit().run();
                    keepTeam.run();
                });
            }
        });
    }

    /** Removes the listeners and releases the window; does not affect the robots. */
    @Override
    public void dispose() {
        stopKeys.close();
        gamepad.close();
        editor.dispose();
        team.close();
        reconnect.close();
        plots.close();
        super.dispose();
    }

    /** Begins or ends to drive the selected robots by a game controller. */
    void driveByGamepad(boolean on) {
        if (on) {
            gamepad.switchOn();
        } else {
            gamepad.switchOff();
        }
    }

    boolean isDrivenByGamepad() {
        return gamepad.isOn();
    }

    FrameLab lab() {
        return lab;
    }

    void openTeam() {
        teams.chooseAndOpen();
    }

    FrameReconnect reconnecting() {
        return reconnect;
    }

    private void attemptsChanged(Member member) {
        team.changed(member);
    }

    void showWholeMap() {
        team.map().fit();
    }

    private static @Nullable RecordedHistory history(@Nullable Recorder recorder) {
        return recorder == null ? null : recorder.history();
    }

    /** Opens an empty plot, and asks what it is to show. */
    void newPlot() {
        plots.openEmpty();
    }

    Settings settings() {
        return services.settings();
    }

    /** Ends the acts of the selected robots; shows a message if none runs, or no robot is selected. */
    void endAct() {
        List<Member> inAct =
                selection.members().stream().filter(BotStatus::isInAct).toList();
        List<Member> meant = inAct.isEmpty() ? selection.members() : inAct;
        if (meant.isEmpty()) {
            showError(TEXTS.get(totalBots() == 0 ? "noRobot" : "noneSelected"));
        } else {
            channel.submit(ActOffer.endLine(meant.stream().map(Member::number).toList()));
        }
    }

    /** Stores a language for the next start; shows a message if it differs from the present one. */
    void chooseLanguage(Language language) {
        if (language.choose(settings())) {
            commands.messages().line(new Line(Line.Kind.NOTICE, TEXTS.get("language.later")));
        }
    }

    /** Submits a line as if it had been typed; its result is shown among the messages. */
    void submit(String line) {
        parser.parseText(line);
    }

    /** Shows a message that does not come from the session; callable from any thread. */
    void showError(String sentence) {
        session.log().write("error", sentence);
        commands.messages().line(new Line(Line.Kind.ERROR, sentence));
    }

    /** Passes on the lines and messages of the window's parts. */
    private final class Channel implements CommandChannel {
        @Override
        public void submit(String lines) {
            EventThread.background("giving a line", () -> MajicFrame.this.submit(lines));
        }

        @Override
        public void submit(String line, Consumer<Optional<String>> ended) {
            EventThread.background("giving a line", () -> {
                Optional<String> wrong = parser.mistake(line).or(() -> parser.parseText(line));
                EventThread.later(() -> ended.accept(wrong));
            });
        }

        @Override
        public void showError(String sentence) {
            MajicFrame.this.showError(sentence);
        }
    }

    /** Gives the command line the focus at the start, and again when the component that had it is removed. */
    private final class CommandsFirst extends LayoutFocusTraversalPolicy {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getDefaultComponent(Container window) {
            return window == MajicFrame.this ? commands.line() : super.getDefaultComponent(window);
        }
    }
}
