package majic.gui.replay;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import majic.bot.Pose;
import majic.gui.bots.RobotSummary;
import majic.gui.bots.RobotTab;
import majic.gui.bots.RobotTabs;
import majic.gui.kit.EventThread;
import majic.gui.map.MapScene;
import majic.gui.map.TeamMap;
import majic.gui.plot.Plots;
import majic.gui.plot.PlottedPanel;
import majic.panel.map.ZoomableMap;
import majic.recorder.Recording;

/**
 * Shows one part of a recording: the map of the team, the tabbed panes of its robots, the lines of the session, and the
 * time slider. Must be used on the event dispatch thread.
 */
final class ReplayView extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;
    private final transient ReplayPart part;
    private final transient Recording recording;
    private final transient List<ReplayRobot> robots;
    private final transient ReplayPlayer player;
    private final transient ReplayControls.PartTurner turner;
    private final TeamMap map = new TeamMap();
    private final transient ReplayMap seen;
    private final transient Map<ReplayRobot, JLabel> status = new LinkedHashMap<>();
    private final transient Map<ReplayRobot, RobotTab> tabOf = new LinkedHashMap<>();
    private final RobotTabs tabs = new RobotTabs("replayRobots");
    private final JSplitPane middle = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT);
    private final JSplitPane all = new JSplitPane(JSplitPane.VERTICAL_SPLIT);
    private final ReplayBand band;
    private final ReplayLines lines;
    private final ReplayControls controls;

    /**
     * Creates a view, paused at the beginning.
     *
     * @param plots shows the curves of figures
     * @param turner goes to other parts of the recording
     */
    ReplayView(ReplayPart part, ReplayServices services, Plots plots, ReplayControls.PartTurner turner) {
        super(new BorderLayout());
        this.part = part;
        this.recording = part.recording();
        this.turner = turner;
        this.seen = new ReplayMap(recording.tracks());
        this.robots = recording.tracks().stream()
                .map(tracks -> new ReplayRobot(services.type(tracks.robot()), tracks))
                .toList();
        this.player = new ReplayPlayer(recording.beginS(), recording.endS(), new Screen());
        this.band = new ReplayBand(part.title(), services.stopButtons().get());
        this.lines = new ReplayLines(recording.lines(), player::jump);
        this.controls = new ReplayControls(part, player, turner);
        robots.forEach(robot -> addTab(robot, plots));
        place();
    }

    private void place() {
        middle.setLeftComponent(map);
        middle.setRightComponent(tabs);
        middle.setResizeWeight(0.55);
        all.setTopComponent(middle);
        all.setBottomComponent(new JScrollPane(lines));
        all.setResizeWeight(0.85);
        add(band, BorderLayout.NORTH);
        add(all, BorderLayout.CENTER);
        add(controls, BorderLayout.SOUTH);
    }

    private void addTab(ReplayRobot robot, Plots plots) {
        JLabel words = new JLabel(" ");
        words.setName("replayStatus" + robot.robot().number());
        words.setBorder(BorderFactory.createEmptyBorder(6, 8, 0, 8));
        status.put(robot, words);
        int number = robot.robot().number();
        JPanel pane = new PlottedPanel(new BorderLayout(), plots, number, robot.tracks()::parameters);
        pane.add(words, BorderLayout.NORTH);
        pane.add(robot.display().component(), BorderLayout.CENTER);
        RobotTab tab = new RobotTab(number, plots, robot.tracks()::parameters);
        tabOf.put(robot, tab);
        tabs.insert(tab, pane);
    }

    /** Shows the time at which the first robot was added, and starts the thread of the player. */
    void start() {
        recording.robots().stream().findFirst().ifPresent(robot -> player.jump(robot.addedS()));
        player.start();
    }

    /** Takes speed, robot and dividers from the view of another part. */
    void continueAs(ReplayView before, boolean playing) {
        middle.setDividerLocation(before.middle.getDividerLocation());
        all.setDividerLocation(before.all.getDividerLocation());
        before.shownRobot().ifPresent(this::showRobot);
        controls.setSpeed(before.player.speed());
        if (playing) {
            player.play();
        }
    }

    private OptionalInt shownRobot() {
        int tab = tabs.getSelectedIndex();
        return tab < 0
                ? OptionalInt.empty()
                : OptionalInt.of(tabs.tabs().get(tab).number());
    }

    private void showRobot(int number) {
        IntStream.range(0, robots.size())
                .filter(tab -> tabs.tabs().get(tab).number() == number)
                .reduce((earlier, later) -> later)
                .ifPresent(tabs::setSelectedIndex);
    }

    /** Returns the position, seconds of the recording; on any thread. */
    double position() {
        return player.position();
    }

    /** Returns the component that has the focus first. */
    Component first() {
        return controls.playButton();
    }

    /** Disables what goes to other parts, until one is shown or cannot be read. */
    void setTurning(boolean turning) {
        controls.setTurning(turning);
    }

    void showProblem(String reason) {
        band.showProblem(reason);
        setTurning(false);
    }

    /** Ends the replay of this part. */
    @Override
    public void close() {
        player.close();
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
                seen.at(atS),
                guessed);
    }

    /** Shows the position of the player in all parts of the window. */
    private final class Screen implements ReplayPlayer.Screen {
        @Override
        public void jump(double toS) {
            robots.forEach(robot -> robot.jump(toS));
            EventThread.later(() -> clearMaps(tabs));
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
            List<RobotSummary> now =
                    robots.stream().map(robot -> robot.summary(positionS)).toList();
            EventThread.later(() -> {
                map.show(scene);
                int index = 0;
                for (ReplayRobot robot : robots) {
                    status.get(robot).setText(words.get(index));
                    tabOf.get(robot).show(now.get(index++));
                }
                lines.follow(positionS);
                controls.show(positionS, playing);
            });
        }

        /** Goes on with the next part. */
        @Override
        public void ended() {
            part.adjacent().next().ifPresent(next -> EventThread.later(() -> turner.turnTo(next, true)));
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
