package majic.gui;

import com.formdev.flatlaf.FlatLaf;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.MenuSelectionManager;
import majic.environment.Settings;
import majic.gui.drive.GamepadControl;
import majic.gui.kit.IconAction;
import majic.gui.kit.Mnemonics;
import majic.gui.map.TeamMap;
import majic.gui.plot.Plots;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/** The menu bar. Its menus are empty until {@link #fill}, because their entries would delay the window. */
final class FrameMenu extends JMenuBar {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(FrameMenu.class);

    private final transient KeyEventDispatcher keys = this::isTypedInMenu;
    private boolean pressedInMenu;
    private final JMenu file = add("file");
    private final JMenu robot = add("robot");
    private final JMenu act = add("act");
    private final JMenu lab = add("lab");
    private final JMenu map = add("map");
    private final JMenu view = add("view");
    private final JMenu window = add("window");
    private final JMenu help = add("help");

    /**
     * The parts of the window that entries of the menus change.
     *
     * @param chosenLanguage receives the language that was chosen
     */
    record Parts(
            FrameEditor editor,
            FrameLab lab,
            FrameReconnect reconnect,
            GamepadControl gamepad,
            TeamMap map,
            MapMenu mapMenu,
            Plots plots,
            AlarmSound alarmSound,
            Settings settings,
            Consumer<Language> chosenLanguage) {}

    private JMenu add(String name) {
        return add(new JMenu(TEXTS.get(name)));
    }

    /**
     * Adds the entries of the menus; has no effect when called again.
     *
     * @param actions those of the buttons
     * @param parts what the entries without an action change
     */
    void fill(FrameActions actions, FrameActions.MenuActions others, Parts parts) {
        if (file.getItemCount() > 0) {
            return;
        }
        fillFile(actions, others, parts.editor);
        fillRobot(actions, others, parts);
        fill(act, actions.loadAct, others.endAct, null, others.makeAct);
        fillLab(parts.lab);
        parts.mapMenu.fill(map, parts.map);
        fillView(parts);
        WindowMenu.fill(window);
        fill(help, actions.help, others.guide, others.tour, null, others.about);
        Mnemonics.assign(this);
    }

    @Override
    public void addNotify() {
        super.addNotify();
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(keys);
    }

    @Override
    public void removeNotify() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(keys);
        super.removeNotify();
    }

    /**
     * Discards the character of a key that was pressed in an open menu. The menu handles the press and closes, and the
     * character would then be typed into the component that gets the focus back.
     */
    private boolean isTypedInMenu(KeyEvent event) {
        if (event.getID() == KeyEvent.KEY_PRESSED) {
            pressedInMenu = MenuSelectionManager.defaultManager().getSelectedPath().length > 0;
        }
        return event.getID() == KeyEvent.KEY_TYPED && pressedInMenu;
    }

    /** Adds the given actions to a menu; null stands for a separator. */
    private static void fill(JMenu menu, @Nullable IconAction... actions) {
        for (IconAction action : actions) {
            if (action == null) {
                menu.addSeparator();
            } else {
                JMenuItem entry = menu.add(new JMenuItem(action));
                entry.setText(action.entryText());
                entry.setToolTipText(null);
            }
        }
    }

    private void fillFile(FrameActions actions, FrameActions.MenuActions others, FrameEditor editor) {
        fill(file, others.newScript, others.openScript);
        JMenu recent = new JMenu(TEXTS.get("openRecent"));
        recent.addChangeListener(change -> {
            if (recent.isSelected()) {
                editor.fillRecent(recent);
                Mnemonics.assign(recent);
            }
        });
        file.add(recent);
        fill(file, null, actions.saveSession, actions.saveLog, null, others.openRecording, null, actions.killMajic);
    }

    private void fillRobot(FrameActions actions, FrameActions.MenuActions others, Parts parts) {
        fill(
                robot,
                actions.addBot,
                actions.killBot,
                null,
                others.openTeam,
                others.saveTeam,
                null,
                others.shareRobots,
                null,
                others.driveByKeys);
        JMenuItem reconnect = new JCheckBoxMenuItem(TEXTS.get("reconnect"), parts.reconnect.isEnabled());
        reconnect.addActionListener(event -> parts.reconnect.enable(reconnect.isSelected()));
        JMenuItem gamepad = new JCheckBoxMenuItem(TEXTS.get("gamepad"));
        gamepad.addActionListener(event -> {
            if (gamepad.isSelected()) {
                parts.gamepad.switchOn();
            } else {
                parts.gamepad.switchOff();
            }
        });
        robot.addChangeListener(change -> gamepad.setSelected(parts.gamepad.isOn()));
        robot.add(gamepad);
        robot.addSeparator();
        robot.add(reconnect);
    }

    private void fillLab(FrameLab simulated) {
        JMenuItem start = new JMenuItem(TEXTS.get("startLab"));
        start.addActionListener(event -> simulated.start());
        JMenuItem poses = new JMenuItem(TEXTS.get("truePositions"));
        poses.addActionListener(event -> simulated.showTruePositions());
        lab.add(start);
        lab.add(poses);
        lab.addChangeListener(change -> {
            start.setEnabled(simulated.canStart());
            poses.setEnabled(simulated.isRunning());
        });
    }

    private void fillView(Parts parts) {
        JMenuItem all = new JMenuItem(TEXTS.get("wholeMap"));
        all.addActionListener(event -> parts.map.fit());
        view.add(all);
        JMenuItem plot = new JMenuItem(TEXTS.get("newPlot"));
        plot.addActionListener(event -> parts.plots.openEmpty());
        view.add(plot);
        view.addSeparator();
        ButtonGroup group = new ButtonGroup();
        for (boolean dark : List.of(false, true)) {
            JMenuItem look = new JRadioButtonMenuItem(TEXTS.get(dark ? "dark" : "light"), FlatLaf.isLafDark() == dark);
            look.addActionListener(event -> LookAndFeels.change(dark, parts.settings));
            group.add(look);
            view.add(look);
        }
        view.addSeparator();
        JMenuItem sound = new JCheckBoxMenuItem(TEXTS.get("alarmSound"), parts.alarmSound.isOn());
        sound.addActionListener(event -> parts.alarmSound.switchOn(sound.isSelected()));
        view.add(sound);
        view.addSeparator();
        view.add(textSize(parts.settings));
        view.add(language(parts));
    }

    private static JMenu textSize(Settings settings) {
        JMenu sizes = new JMenu(TEXTS.get("textSize"));
        ButtonGroup group = new ButtonGroup();
        for (int percent : LookAndFeels.TEXT_SIZES) {
            JMenuItem size = new JRadioButtonMenuItem(percent + " %", LookAndFeels.textSize(settings) == percent);
            size.addActionListener(event -> LookAndFeels.changeTextSize(percent, settings));
            group.add(size);
            sizes.add(size);
        }
        return sizes;
    }

    private static JMenu language(Parts parts) {
        JMenu languages = new JMenu(TEXTS.get("language"));
        ButtonGroup group = new ButtonGroup();
        for (Language language : Language.values()) {
            JMenuItem entry =
                    new JRadioButtonMenuItem(language.toString(), language == Language.chosen(parts.settings));
            entry.addActionListener(event -> parts.chosenLanguage.accept(language));
            group.add(entry);
            languages.add(entry);
        }
        return languages;
    }
}
