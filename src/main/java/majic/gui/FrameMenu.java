package majic.gui;

import com.formdev.flatlaf.FlatLaf;
import java.util.List;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import majic.gui.kit.IconAction;
import majic.gui.kit.Mnemonics;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/** The menu bar. Its menus are empty until {@link #fill}, because their entries would delay the window. */
final class FrameMenu extends JMenuBar {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(FrameMenu.class);

    private final transient MenuKeys keys = new MenuKeys();
    private final JMenu file = add("file");
    private final JMenu robot = add("robot");
    private final JMenu act = add("act");
    private final JMenu lab = add("lab");
    private final JMenu view = add("view");
    private final JMenu window = add("window");
    private final JMenu help = add("help");

    private JMenu add(String name) {
        return add(new JMenu(TEXTS.get(name)));
    }

    /**
     * Adds the entries of the menus; has no effect when called again.
     *
     * @param actions those of the buttons
     */
    void fill(MajicFrame frame, FrameActions actions, FrameActions.MenuActions others, FrameEditor editor) {
        if (file.getItemCount() > 0) {
            return;
        }
        fillFile(actions, others, editor);
        fillRobot(frame, actions, others);
        fill(act, actions.loadAct, others.endAct, null, others.makeAct);
        fillLab(lab, frame);
        fillView(view, frame);
        WindowMenu.fill(window);
        fill(help, actions.help, others.guide, others.tour, null, others.about);
        Mnemonics.assign(this);
    }

    @Override
    public void addNotify() {
        super.addNotify();
        keys.install();
    }

    @Override
    public void removeNotify() {
        keys.remove();
        super.removeNotify();
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

    private void fillRobot(MajicFrame frame, FrameActions actions, FrameActions.MenuActions others) {
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
        JMenuItem reconnect = new JCheckBoxMenuItem(
                TEXTS.get("reconnect"), frame.reconnecting().isEnabled());
        reconnect.addActionListener(event -> frame.reconnecting().enable(reconnect.isSelected()));
        JMenuItem gamepad = new JCheckBoxMenuItem(TEXTS.get("gamepad"));
        gamepad.addActionListener(event -> {
            if (gamepad.isSelected()) {
                frame.gamepad().switchOn();
            } else {
                frame.gamepad().switchOff();
            }
        });
        robot.addChangeListener(change -> gamepad.setSelected(frame.gamepad().isOn()));
        robot.add(gamepad);
        robot.addSeparator();
        robot.add(reconnect);
    }

    private static void fillLab(JMenu lab, MajicFrame frame) {
        JMenuItem start = new JMenuItem(TEXTS.get("startLab"));
        start.addActionListener(event -> frame.lab().start());
        JMenuItem poses = new JMenuItem(TEXTS.get("truePositions"));
        poses.addActionListener(event -> frame.lab().showTruePositions());
        lab.add(start);
        lab.add(poses);
        lab.addChangeListener(change -> {
            start.setEnabled(frame.lab().canStart());
            poses.setEnabled(frame.lab().isRunning());
        });
    }

    private static void fillView(JMenu view, MajicFrame frame) {
        JMenuItem all = new JMenuItem(TEXTS.get("wholeMap"));
        all.addActionListener(event -> frame.showWholeMap());
        view.add(all);
        JMenuItem plot = new JMenuItem(TEXTS.get("newPlot"));
        plot.addActionListener(event -> frame.newPlot());
        view.add(plot);
        view.addSeparator();
        ButtonGroup group = new ButtonGroup();
        for (boolean dark : List.of(false, true)) {
            JMenuItem look = new JRadioButtonMenuItem(TEXTS.get(dark ? "dark" : "light"), FlatLaf.isLafDark() == dark);
            look.addActionListener(event -> LookAndFeels.change(dark, frame.settings()));
            group.add(look);
            view.add(look);
        }
        view.addSeparator();
        JMenuItem sound = new JCheckBoxMenuItem(
                TEXTS.get("alarmSound"), frame.alarmSound().isOn());
        sound.addActionListener(event -> frame.alarmSound().switchOn(sound.isSelected()));
        view.add(sound);
        view.addSeparator();
        view.add(textSize(frame));
        view.add(language(frame));
    }

    private static JMenu textSize(MajicFrame frame) {
        JMenu sizes = new JMenu(TEXTS.get("textSize"));
        ButtonGroup group = new ButtonGroup();
        for (int percent : LookAndFeels.TEXT_SIZES) {
            JMenuItem size =
                    new JRadioButtonMenuItem(percent + " %", LookAndFeels.textSize(frame.settings()) == percent);
            size.addActionListener(event -> LookAndFeels.changeTextSize(percent, frame.settings()));
            group.add(size);
            sizes.add(size);
        }
        return sizes;
    }

    private static JMenu language(MajicFrame frame) {
        JMenu languages = new JMenu(TEXTS.get("language"));
        ButtonGroup group = new ButtonGroup();
        for (Language language : Language.values()) {
            JMenuItem entry =
                    new JRadioButtonMenuItem(language.toString(), language == Language.chosen(frame.settings()));
            entry.addActionListener(event -> frame.chooseLanguage(language));
            group.add(entry);
            languages.add(entry);
        }
        return languages;
    }
}
