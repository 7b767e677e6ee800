package majic.gui.replay;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.WindowConstants;
import majic.bot.BotException;
import majic.bot.Pose;
import majic.gui.kit.EventThread;
import majic.gui.kit.NumberBadge;
import majic.gui.kit.PictureDialog;
import majic.gui.map.MapScene;
import majic.gui.map.TeamMap;
import majic.gui.plot.Plots;
import majic.gui.plot.data.RecordedSource;
import majic.panel.PictureView;
import majic.panel.PictureViewer;
import majic.panel.map.ZoomableMap;
import majic.recorder.Recording;
import majic.text.IoReason;
import majic.text.Texts;

/**
 * Replays one file of a recording: the map of the team, the panels of its robots, the lines of the session, and the
 * time slider. Must be used on the event dispatch thread.
 */
public final class ReplayWindow extends JFrame implements PictureViewer {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ReplayWindow.class);
    private static final int BADGE_PX = 18;

    private final transient Recording recording;
    private final transient ReplayServices services;
    private final transient List<ReplayRobot> robots;
    private final transient ReplayPlayer player;
    private final TeamMap map = new TeamMap();
    private final transient Map<ReplayRobot, JLabel> status = new LinkedHashMap<>();
    private final JTabbedPane panels = new JTabbedPane();
    private final ReplayLines lines;
    private final ReplayControls controls;
    private final transient Plots plots;

    private ReplayWindow(Recording recording, ReplayServices services) {
        super(TEXTS.get("title", ReplayTimes.day(recording.head().begin())));
        this.recording = recording;
        this.services = services;
        this.robots = recording.tracks().stream()
                .map(tracks -> new ReplayRobot(services.type(tracks.robot()), tracks))
                .toList();
        this.player = new ReplayPlayer(recording.beginS(), recording.endS(), new Screen());
        this.lines = new ReplayLines(recording.lines(), player::jump);
        this.controls = new ReplayControls(recording, player);
        this.plots = new Plots(
                this,
                services.settings(),
                () -> new RecordedSource(recording, player::position),
                services.stopButtons());
        setName("replay");
        place();
    }

    /**
     * Reads a recording in the background and opens its window, paused at its beginning.
     *
     * @param owner the window beside which it opens
     * @param file a file of a recording
     * @param services what a replay needs
     * @param opened called on the event dispatch thread when the window is shown
     * @param failed receives the reason if the file cannot be read, as a sentence, on the event dispatch thread
     */
    public static void open(
            Window owner, Path file, ReplayServices services, Runnable opened, Consumer<String> failed) {
        EventThread.background(
                "opening " + file.getFileName(),
                () -> {
                    Recording recording = read(file);
                    EventThread.later(() -> {
                        show(owner, recording, services);
                        opened.run();
                    });
                },
                failed);
    }

    private static Recording read(Path file) {
        try {
            return Recording.read(file);
        } catch (IOException e) {
            throw new BotException(file + ": " + IoReason.of(e), e);
        }
    }

    private static void show(Window owner, Recording recording, ReplayServices services) {
        ReplayWindow window = new ReplayWindow(recording, services);
        if (owner instanceof Frame frame) {
            window.setIconImages(frame.getIconImages());
        }
        window.setLocationRelativeTo(owner);
        window.setVisible(true);
        recording.robots().stream().findFirst().ifPresent(robot -> window.player.jump(robot.addedS()));
        window.player.start();
    }

    private void place() {
        robots.forEach(this::addTab);
        panels.setName("replayRobots");
        panels.setPreferredSize(UIScale.scale(new Dimension(540, 400)));
        panels.setMinimumSize(UIScale.scale(new Dimension(360, 200)));
        JSplitPane middle = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, map, panels);
        middle.setResizeWeight(0.55);
        JSplitPane all = new JSplitPane(JSplitPane.VERTICAL_SPLIT, middle, new JScrollPane(lines));
        all.setResizeWeight(0.85);
        JPanel content = new JPanel(new BorderLayout());
        content.add(new ReplayBand(ReplayTimes.day(recording.head().begin())), BorderLayout.NORTH);
        content.add(all, BorderLayout.CENTER);
        content.add(controls, BorderLayout.SOUTH);
        setContentPane(content);
        setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        setMinimumSize(new Dimension(700, 520));
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        setSize(Math.min(UIScale.scale(1200), screen.width), Math.min(UIScale.scale(780), screen.height));
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                controls.playButton().requestFocusInWindow();
            }
        });
    }

    private void addTab(ReplayRobot robot) {
        JLabel words = new JLabel(" ");
        words.setName("replayStatus" + robot.robot().number());
        words.setBorder(BorderFactory.createEmptyBorder(6, 8, 0, 8));
        status.put(robot, words);
        JPanel tab = new PlottedPanel(robot, plots);
        tab.add(words, BorderLayout.NORTH);
        tab.add(robot.display().component(), BorderLayout.CENTER);
        panels.addTab(robot.robot().label(), new NumberBadge(robot.robot().number(), BADGE_PX), tab);
    }

    @Override
    public void enlarge(PictureView view) {
        new PictureDialog(this, view, services.settings()).setVisible(true);
    }

    /** Ends the replay. */
    @Override
    public void dispose() {
        player.close();
        plots.close();
        super.dispose();
        EventThread.background("closing a replay", () -> robots.forEach(ReplayRobot::close));
    }

    private MapScene scene(double atS) {
        Map<String, Pose> others = new LinkedHashMap<>(recording.truePoses(atS));
        List<MapScene.Robot> shown = new ArrayList<>();
        boolean guessed = false;
        for (ReplayRobot robot : robots) {
            if (robot.isPresent(atS)) {
                shown.add(robot.onMap(recording, atS));
                others.remove(robot.robot().inLab());
                guessed |= robot.robot().inLab().isEmpty() && !robot.tracks().isPlaced(atS);
            }
        }
        return new MapScene(
                recording.room().walls(),
                recording.room().furnishing(),
                shown,
                others.entrySet().stream()
                        .map(other -> new MapScene.Bystander(other.getKey(), other.getValue()))
                        .toList(),
                guessed);
    }

    /** Shows the position of the player in all parts of the window. */
    private final class Screen implements ReplayPlayer.Screen {
        @Override
        public void jump(double toS) {
            robots.forEach(robot -> robot.jump(toS));
            EventThread.later(() -> clearMaps(panels));
        }

        @Override
        public void advance(double fromS, double toS) {
            robots.forEach(robot -> robot.advance(fromS, toS));
        }

        @Override
        public void moved(double positionS, boolean playing) {
            MapScene scene = scene(positionS);
            List<String> words =
                    robots.stream().map(robot -> robot.status(positionS)).toList();
            EventThread.later(() -> {
                map.show(scene);
                int index = 0;
                for (JLabel label : status.values()) {
                    label.setText(words.get(index++));
                }
                lines.follow(positionS);
                controls.show(positionS, playing);
            });
        }

        /** Removes the ways and echoes of another time from the robots' own maps. */
        private static void clearMaps(Container parts) {
            for (Component part : parts.getComponents()) {
                if (part instanceof ZoomableMap own) {
                    own.clear();
                } else if (part instanceof Container inner) {
                    clearMaps(inner);
                }
            }
        }
    }
}
