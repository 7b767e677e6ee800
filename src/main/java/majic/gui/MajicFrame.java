package majic.gui;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.VolatileImage;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.LayoutFocusTraversalPolicy;
import javax.swing.RootPaneContainer;
import javax.swing.Timer;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.environment.Settings;
import majic.gui.bots.RobotActions;
import majic.gui.bots.TeamTabs;
import majic.gui.command.CommandLine;
import majic.gui.command.CommandPane;
import majic.gui.command.MessageArea;
import majic.gui.drive.GamepadControl;
import majic.gui.drive.GuardChoice;
import majic.gui.drive.SdlGamepad;
import majic.gui.kit.EventThread;
import majic.gui.kit.FileDrop;
import majic.gui.kit.Icons;
import majic.gui.kit.ProgramServices;
import majic.gui.kit.RobotSelection;
import majic.gui.kit.RobotSharing;
import majic.gui.kit.StopButton;
import majic.gui.plot.Plots;
import majic.gui.plot.data.LiveSource;
import majic.gui.start.StartActions;
import majic.gui.start.StartPage;
import majic.panel.PictureView;
import majic.panel.PictureViewer;
import majic.script.MajicParser;
import majic.script.Session;
import majic.team.Member;
import majic.text.Texts;

/**
 * The main window: buttons and STOP above; team map and the tabbed panes of the robots side by side; messages and
 * command line below. Places its parts, and passes commands on to the team and the parser. Must be used on the event
 * dispatch thread.
 */
public final class MajicFrame extends JFrame implements PictureViewer {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(MajicFrame.class);
    private static final int ICON_SIZE = 64;

    /** When the window is painted after it was opened, even by a slow computer. */
    private static final int AFTER_PAINTING_MS = 100;

    private final transient Session session;
    private final transient ProgramServices services;
    private final transient StopKeys stopKeys;
    private final transient HelpKey helpKey;
    private final transient FrameDialogs dialogs;
    private final transient FrameEditor editor;
    private final transient FrameTeams teams;
    private final transient FrameLab lab;
    private final transient FrameReconnect reconnect;
    private final transient FrameChannel channel;
    private final transient Plots plots;
    private final transient RobotSelection selection = new RobotSelection();
    private final transient GamepadControl gamepad;
    private final transient FrameMemory memory;
    private final transient AlarmSound alarmSound;
    private final StartPage start;
    private final TeamTabs mainPane;
    private final TeamPane team;
    private final CommandPane commands;
    private final MessageArea msgArea;
    private final CommandLine commandLine;
    private final JButton addButton;
    private final JButton removeButton;
    private final JButton actionButton;
    private final JButton killButton;
    private boolean quitting;

    /**
     * Creates the window, not yet visible.
     *
     * @param session the session that it shows
     * @param parser parses the lines typed here; interactive
     * @param services what the program provides
     */
    public MajicFrame(Session session, MajicParser parser, ProgramServices services) {
        this(session, parser, services, AFTER_PAINTING_MS);
    }

    /**
     * Creates a window that is completed at another time.
     *
     * @param completionMs when what would have delayed the window is added after it was opened, ms; 0 for at once
     */
    MajicFrame(Session session, MajicParser parser, ProgramServices services, int completionMs) {
        super("MAJIC");
        this.session = session;
        this.services = services;
        commands = new CommandPane(parser, services, session::alarm, this::openScript);
        msgArea = commands.messages();
        commandLine = commands.line();
        channel = new FrameChannel(session, parser, msgArea);
        GuardChoice guard = new GuardChoice(services.settings());
        gamepad = new GamepadControl(SdlGamepad::open, guard, channel::showError, channel::showError);
        plots = new Plots(
                this, services.settings(), () -> new LiveSource(session.team(), services.recorded()), this::stopButton);
        reconnect = new FrameReconnect(session.team(), services.settings(), this::attemptsChanged);
        parser.useDefaultRobots(selection::numbers);
        dialogs = new FrameDialogs(this, session, services, selection, channel, this::stopButton);
        lab = new FrameLab(session, services, channel);
        teams = new FrameTeams(this, session, services, channel);
        editor = new FrameEditor(this, session, services, this::stopAll, commandLine::submit, dialogs, teams);
        RobotActions ofRobots = new RobotActions(
                session.team(),
                channel,
                plots,
                dialogs::loadAct,
                dialogs::removeBot,
                reconnect.attempts(),
                session::address);
        selection.addListener(() -> gamepad.choose(selection.members()));
        start = startPage();
        mainPane = new TeamTabs(session.team(), selection, ofRobots, guard);
        team = new TeamPane(session, selection, mainPane, start);
        team.map().place(session.team(), channel, member -> teams.last().keepSoon());
        team.map().usePlaces(channel, commandLine::propose);
        team.map().useWaypoints(this::openScript, channel::showError);
        alarmSound = new AlarmSound(services.settings(), AlarmSound::play);
        stopKeys = new StopKeys(session.team(), this::stopAll);
        helpKey = new HelpKey(dialogs::help);
        FrameActions actions = new FrameActions(dialogs, editor, this::quit);
        addButton = FrameToolbar.button(actions.addBot);
        removeButton = FrameToolbar.button(actions.killBot);
        actionButton = FrameToolbar.button(actions.loadAct);
        killButton = FrameToolbar.button(actions.killMajic);
        memory = place(actions, completionMs);
        listen(parser);
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

    private FrameMemory place(FrameActions actions, int completionMs) {
        List<JButton> buttons = List.of(
                addButton,
                removeButton,
                actionButton,
                FrameToolbar.button(actions.help),
                FrameToolbar.button(actions.saveSession),
                FrameToolbar.button(actions.saveLog),
                killButton);
        FrameContent content = new FrameContent(session.team(), buttons, this::stopAll, team, commands);
        setContentPane(content);
        FrameMenu menu = new FrameMenu();
        setJMenuBar(menu);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                Timer painted = new Timer(completionMs, done -> complete(menu, actions));
                painted.setRepeats(false);
                painted.start();
            }

            @Override
            public void windowClosing(WindowEvent event) {
                quit();
            }
        });
        setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
        setFocusTraversalPolicy(new CommandsFirst());
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        setMinimumSize(leastSize(screen));
        setSize(Math.min(UIScale.scale(1280), screen.width), Math.min(UIScale.scale(800), screen.height));
        setLocationRelativeTo(null);
        FileDrop.postponeInside(getRootPane());
        return new FrameMemory(this, content.splits(), mainPane, services.settings());
    }

    /** Returns the least size of the window, which is never larger than the screen. */
    static Dimension leastSize(Rectangle screen) {
        return new Dimension(Math.min(UIScale.scale(700), screen.width), Math.min(UIScale.scale(520), screen.height));
    }

    /** Adds what would have delayed the window. */
    private void complete(FrameMenu menu, FrameActions actions) {
        setIconImage(Icons.program(ICON_SIZE));
        commands.complete(session.questions());
        menu.fill(
                actions,
                new FrameActions.MenuActions(dialogs, editor, teams, this::driveByKeys),
                new FrameMenu.Parts(
                        editor,
                        lab,
                        reconnect,
                        gamepad,
                        team.map(),
                        new MapMenu(this, session, services.settings(), selection, channel, commandLine::propose),
                        plots,
                        alarmSound,
                        services.settings(),
                        this::chooseLanguage));
        FileDrop.installInside(getRootPane(), editor::openDropped);
        MacMenu.install(this::quit, dialogs::about);
        WindowPreloader.preparePanels();
    }

    private void listen(MajicParser parser) {
        session.usePlots(
                (robots, parameters) -> EventThread.later(() -> EventThread.piece(() -> plot(robots, parameters))));
        session.addListener(msgArea);
        session.addListener(alarmSound);
        RobotSharing sharing = services.sharing();
        if (sharing != null) {
            session.addListener(new FrameLogins(this, sharing, parser, channel));
        }
        stopKeys.install();
        helpKey.install();
        team.start();
    }

    private void openScript(String lines) {
        editor.newScript(lines);
    }

    private void plot(List<Integer> robots, List<String> parameters) {
        if (isDisplayable() && !plots.plotAlone(robots, parameters)) {
            channel.showError(TEXTS.get("nothingToPlot", String.join(",", parameters)));
        }
    }

    /** Makes the STOP button of a window beside this one. */
    StopButton stopButton() {
        return new StopButton(session.team(), this::stopAll);
    }

    private void stopAll() {
        if (!session.team().stopAllIfAny()) {
            channel.showError(TEXTS.get("noRobotToStop"));
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
        session.removeListener(msgArea);
        session.removeListener(alarmSound);
        stopKeys.close();
        helpKey.close();
        gamepad.close();
        editor.dispose();
        team.close();
        reconnect.close();
        plots.close();
        super.dispose();
    }

    /**
     * Paints the window, its dialogs, a plot and the other look and feel without showing them, so that the Java machine
     * can record the classes that they need, and keeps the place of the window, with which the next rehearsal begins.
     * Must be called on the event dispatch thread.
     */
    public void rehearse() {
        paintUnseen(this);
        dialogs.rehearse();
        plots.rehearse(MajicFrame::paintUnseen);
        memory.keep();
        LookAndFeels.rehearse();
    }

    /** Paints a window that has a size but is not shown. */
    static <W extends Window & RootPaneContainer> void paintUnseen(W window) {
        VolatileImage picture = window.createVolatileImage(window.getWidth(), window.getHeight());
        window.getRootPane().paint(picture.createGraphics());
    }

    private void attemptsChanged(Member member) {
        mainPane.ownerChanged(member);
    }

    /** Lets the arrow keys drive the selected robots; shows a message if there is no robot. */
    private void driveByKeys() {
        if (session.team().members().isEmpty()) {
            channel.showError(TEXTS.get("noRobot"));
        } else {
            mainPane.focusPad();
        }
    }

    /** Stores a language for the next start; shows a message if it differs from the present one. */
    void chooseLanguage(Language language) {
        if (language.choose(services.settings())) {
            channel.showNotice(TEXTS.get("language.later"));
        }
    }

    /** Gives the command line the focus at the start, and again when the component that had it is removed. */
    private final class CommandsFirst extends LayoutFocusTraversalPolicy {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getDefaultComponent(Container window) {
            return window == MajicFrame.this ? commandLine : super.getDefaultComponent(window);
        }
    }
}
