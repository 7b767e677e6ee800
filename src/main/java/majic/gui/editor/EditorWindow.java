package majic.gui.editor;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.Timer;
import majic.gui.command.QuestionStrip;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.ClearOfStop;
import majic.gui.kit.Confirm;
import majic.gui.kit.EventThread;
import majic.gui.kit.EventThreadTeamListener;
import majic.gui.kit.FileDrop;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.PlainTextUi;
import majic.gui.kit.StopButton;
import majic.script.ScriptRunner;
import majic.team.Member;
import majic.team.TeamListener;
import majic.text.Texts;

/**
 * The script editor: opens, edits, checks, runs and saves scripts and saved sessions, each in a tab. Must be used on
 * the event dispatch thread.
 */
public final class EditorWindow extends JFrame {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(EditorWindow.class);
    private static final int LOOK_AT_FILES_MS = 2000;

    private final transient EditorContext context;
    private final transient ScriptRunner runner;
    private final transient EditorActions actions = new EditorActions(this);
    private final EditorToolbar toolbar;
    private final FileNotice notice = new FileNotice();
    private final JTabbedPane tabs = new JTabbedPane(JTabbedPane.TOP, JTabbedPane.SCROLL_TAB_LAYOUT);
    private final StatusBar status = new StatusBar();
    private final Timer looking = new Timer(LOOK_AT_FILES_MS, event -> lookAtFiles());
    private final transient TeamListener team = new EventThreadTeamListener(new Rechecking());
    private int created;

    /**
     * Creates the window without a script; it is shown with the first one.
     *
     * @param near the window that it is placed on
     */
    public EditorWindow(EditorContext context, Window near) {
        super(TEXTS.get("title"));
        HelpTopic.set(getRootPane(), "the-script-editor");
        this.context = context;
        this.runner = new ScriptRunner(context.session());
        setName("editor");
        toolbar = new EditorToolbar(
                actions.buttons(), new StopButton(context.session().team(), context.stopAll()));
        place();
        listen();
        setIconImages(near.getIconImages());
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        setMinimumSize(new Dimension(640, 400));
        setSize(Math.min(UIScale.scale(1000), screen.width), Math.min(UIScale.scale(720), screen.height));
        setLocationRelativeTo(near);
        ClearOfStop.place(this, near);
    }

    private void place() {
        tabs.setName("scripts");
        tabs.getAccessibleContext().setAccessibleName(TEXTS.get("scripts"));
        tabs.putClientProperty("JTabbedPane.tabClosable", true);
        tabs.putClientProperty("JTabbedPane.tabCloseToolTipText", TEXTS.get("tab.close"));
        tabs.putClientProperty("JTabbedPane.tabCloseCallback", (BiConsumer<JTabbedPane, Integer>)
                (all, index) -> close((EditorTab) all.getComponentAt(index), () -> {}));
        JPanel top = new JPanel(new BorderLayout());
        top.add(toolbar, BorderLayout.CENTER);
        top.add(notice, BorderLayout.SOUTH);
        JPanel content = new JPanel(new BorderLayout());
        content.add(top, BorderLayout.NORTH);
        content.add(tabs, BorderLayout.CENTER);
        JPanel bottom = new JPanel(new BorderLayout());
        bottom.add(
                new QuestionStrip(context.session().questions(), context.submit(), this::focusText),
                BorderLayout.NORTH);
        bottom.add(status, BorderLayout.SOUTH);
        content.add(bottom, BorderLayout.SOUTH);
        setContentPane(content);
        setJMenuBar(new EditorMenu(this, context, actions));
    }

    private void listen() {
        tabs.addChangeListener(event -> showTab());
        context.session().team().addListener(team);
        FileDrop.install(getRootPane(), context.dropped());
        setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
        addWindowListener(new WindowAdapter() {
            /**
             * Requests the focus, because a window manager may give it to another window when a dialog has just closed.
             */
            @Override
            public void windowOpened(WindowEvent event) {
                toFront();
                focusText();
            }

            @Override
            public void windowClosing(WindowEvent event) {
                closeAll(() -> {});
            }

            @Override
            public void windowActivated(WindowEvent event) {
                lookAtFiles();
            }
        });
        looking.start();
    }

    private void lookAtFiles() {
        if (isShowing()) {
            all().forEach(tab -> tab.file().look());
        }
    }

    /** Opens a script that is not saved yet, perhaps an empty one, in a new tab. */
    public void newScript(String text) {
        created++;
        String name = "script" + (created == 1 ? "" : " " + created) + ScriptFile.ENDING;
        add(ScriptFile.fresh(Path.of(name)), false).replaceText(text);
    }

    /** Asks for a script and opens it. */
    public void chooseAndOpen() {
        ChooseFile.toOpen(this, context.settings(), TEXTS.get("openScript"), ChooseFile.scripts(), this::open);
    }

    /** Opens a script, or selects its tab if it is open. It is read in the background. */
    public void open(Path file) {
        Path path = file.toAbsolutePath().normalize();
        Optional<EditorTab> there = all().stream()
                .filter(tab -> tab.file().path().equals(Optional.of(path)))
                .findFirst();
        if (there.isPresent()) {
            tabs.setSelectedComponent(there.get());
            bringToFront();
            return;
        }
        EventThread.background(
                "reading a script",
                () -> {
                    ScriptFile read = ScriptFile.read(path);
                    EventThread.later(() -> opened(read));
                },
                why -> notOpened(path, why));
    }

    private void opened(ScriptFile read) {
        notice.setVisible(false);
        all().stream().filter(EditorTab::isUntouched).findFirst().ifPresent(this::remove);
        add(read, true);
        new RecentFiles(context.settings(), RecentFiles.SCRIPTS).add(read.path());
    }

    private void notOpened(Path path, String why) {
        new RecentFiles(context.settings(), RecentFiles.SCRIPTS).remove(path);
        notice.show(why, new FileNotice.Choice("close", TEXTS.get("notice.close"), () -> {}));
        bringToFront();
    }

    private EditorTab add(ScriptFile file, boolean exists) {
        EditorTab tab = new EditorTab(context, runner, file, exists, this::showTab);
        FileDrop.install(tab.area().text(), context.dropped());
        tabs.addTab(PlainTextUi.title(tab.title()), tab);
        tabs.setSelectedComponent(tab);
        bringToFront();
        return tab;
    }

    private void bringToFront() {
        setVisible(true);
        toFront();
        focusText();
    }

    private void focusText() {
        onTab(tab -> tab.area().text().requestFocus()).run();
    }

    private List<EditorTab> all() {
        return IntStream.range(0, tabs.getTabCount())
                .mapToObj(index -> (EditorTab) tabs.getComponentAt(index))
                .toList();
    }

    /** Returns what does something with the selected tab, if there is one. */
    Runnable onTab(Consumer<EditorTab> action) {
        return () -> {
            if (tabs.getSelectedComponent() instanceof EditorTab tab) {
                action.accept(tab);
            }
        };
    }

    /** Shows titles, and the state of the selected tab. */
    private void showTab() {
        all().forEach(tab -> tabs.setTitleAt(tabs.indexOfComponent(tab), PlainTextUi.title(tab.title())));
        onTab(tab -> {
                    setTitle(TEXTS.get("title.script", tab.file().name()));
                    actions.update(tab.run());
                    toolbar.showRobots(tab.robots());
                    status.show(tab);
                })
                .run();
    }

    /** Makes an act of a script, which is saved before if it has changes. */
    void makeAct(EditorTab tab) {
        if (tab.file().isModified() || tab.file().path().isEmpty()) {
            tab.file().save(() -> makeAct(tab));
        } else {
            tab.file().path().ifPresent(context.makeAct());
        }
    }

    /**
     * Closes a tab; asks first if its script runs or has unsaved changes.
     *
     * @param then called once the tab is closed
     */
    void close(EditorTab tab, Runnable then) {
        tabs.setSelectedComponent(tab);
        Runnable closed = () -> {
            remove(tab);
            then.run();
        };
        if (tab.run().isRunning()) {
            Confirm.ask(this, TEXTS.get("running", tab.file().name()), TEXTS.get("running.end"), () -> {
                tab.run().stop();
                closeSaved(tab, closed);
            });
        } else {
            closeSaved(tab, closed);
        }
    }

    private void closeSaved(EditorTab tab, Runnable closed) {
        if (tab.file().isModified()) {
            UnsavedDialog.ask(this, tab.file().name(), () -> tab.file().save(closed), closed);
        } else {
            closed.run();
        }
    }

    /**
     * Closes all tabs and hides the window; asks as {@link #close} does, and stays open with the tabs that are kept.
     *
     * @param then called once all are closed
     */
    public void closeAll(Runnable then) {
        all().stream().findFirst().ifPresentOrElse(tab -> close(tab, () -> closeAll(then)), () -> {
            setVisible(false);
            then.run();
        });
    }

    private void remove(EditorTab tab) {
        tab.close();
        tabs.remove(tab);
        if (tabs.getTabCount() == 0) {
            setTitle(TEXTS.get("title"));
            setVisible(false);
        }
    }

    /** Removes the listeners and releases the window. */
    @Override
    public void dispose() {
        looking.stop();
        context.session().team().removeListener(team);
        super.dispose();
    }

    /** Checks the scripts again when other robots are there. */
    private final class Rechecking implements TeamListener {
        @Override
        public void added(Member member) {
            all().forEach(EditorTab::checkSoon);
        }

        @Override
        public void removed(Member member) {
            all().forEach(EditorTab::checkSoon);
        }
    }
}
