package majic.gui.replay;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import majic.bot.BotType;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.Pose;
import majic.bot.Uncertainty;
import majic.bot.Value;
import majic.gui.bots.BatteryLevel;
import majic.gui.bots.RobotSummary;
import majic.gui.kit.StateIcon;
import majic.gui.map.MapScene;
import majic.panel.map.Trail;
import majic.recorder.RecordedRobot;
import majic.recorder.Recording;
import majic.recorder.RobotTracks;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * One recorded robot with its panel and its trail. Made on the event dispatch thread; all other methods are called on
 * the thread of the replay.
 */
final class ReplayRobot implements AutoCloseable {
    private static final Texts TEXTS = Texts.of(ReplayRobot.class);
    private static final Logger LOG = System.getLogger(ReplayRobot.class.getName());

    /** A panel needs so much of what came before, to show echoes and all sonar readings. */
    private static final double RUN_UP_S = 3;

    private static final double NANOS_PER_S = 1e9;

    private final RobotTracks tracks;
    private final ReplayBot bot;
    private final ReplayDisplay display;
    private final Trail trail = new Trail();
    private double pictureS = Double.NEGATIVE_INFINITY;

    ReplayRobot(BotType type, RobotTracks tracks) {
        this.tracks = tracks;
        this.bot = new ReplayBot(type, tracks);
        this.display = display(type, bot);
    }

    /** The panel of the robot's own type; a table if there is none, or if it cannot be made. */
    private static ReplayDisplay display(BotType type, ReplayBot bot) {
        try {
            ReplayDisplay own = type.replay(bot);
            return own == null ? new ReadingsTable(bot) : own;
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, "the panel of a recorded " + type.name() + " could not be made", e);
            return new ReadingsTable(bot);
        }
    }

    RecordedRobot robot() {
        return tracks.robot();
    }

    RobotTracks tracks() {
        return tracks;
    }

    ReplayDisplay display() {
        return display;
    }

    boolean isPresent(double seconds) {
        return tracks.isPresent(seconds);
    }

    /** Shows another time, without what lies between. */
    void jump(double toS) {
        trail.clear();
        for (double at : tracks.changes(Double.NEGATIVE_INFINITY, toS)) {
            trail.add(place(at));
        }
        pictureS = Double.NEGATIVE_INFINITY;
        display.reset();
        show(Math.max(robot().addedS(), toS - RUN_UP_S));
        follow(toS - RUN_UP_S, toS);
        show(toS);
    }

    /** Shows the time that follows what is shown, with all that came in between. */
    void advance(double fromS, double toS) {
        for (double at : tracks.changes(fromS, toS)) {
            trail.add(place(at));
        }
        follow(Math.max(fromS, toS - RUN_UP_S), toS);
        show(toS);
    }

    private void follow(double fromS, double toS) {
        Arrays.stream(tracks.changes(fromS, toS)).forEach(this::show);
        tracks.picture(toS).filter(picture -> picture.seconds() > pictureS).ifPresent(picture -> {
            pictureS = picture.seconds();
            display.showPicture(picture.jpeg());
        });
    }

    private void show(double atS) {
        bot.show(atS);
        try {
            display.show(tracks.reports(atS), (long) (atS * NANOS_PER_S));
        } catch (RuntimeException | Error e) {
            LOG.log(Level.DEBUG, "a recorded state cannot be shown", e);
        }
    }

    private Pose place(double atS) {
        return tracks.origin(atS).plus(tracks.pose(atS));
    }

    /** The robot on the map. */
    MapScene.Robot onMap(Recording recording, double atS) {
        @Nullable Pose truth = recording.truePoses(atS).get(robot().inLab());
        return new MapScene.Robot(
                        robot().number(),
                        robot().label(),
                        robot().bodyMm(),
                        tracks.origin(atS),
                        place(atS),
                        uncertainty(atS),
                        truth,
                        trail,
                        bot.isConnected(),
                        !tracks.status("stop", atS).isEmpty(),
                        way(atS))
                .at(tracks.heightMm(atS).orElse(0.0));
    }

    private MapScene.PlannedWay way(double atS) {
        List<Pose> corners =
                tracks.way(atS).stream().map(tracks.origin(atS)::plus).toList();
        return new MapScene.PlannedWay(corners, List.of());
    }

    private Uncertainty uncertainty(double atS) {
        return tracks.parameters().stream()
                .filter(parameter -> parameter.name().equals("placed"))
                .map(parameter -> tracks.value(parameter, atS))
                .filter(Value.Many.class::isInstance)
                .map(value -> ((Value.Many) value).values())
                .filter(parts -> parts.size() == 2)
                .map(parts -> Uncertainty.of(parts.get(0).number(), parts.get(1).number()))
                .findFirst()
                .orElse(Uncertainty.UNKNOWN);
    }

    /** What the tab of the robot shows. */
    RobotSummary summary(double atS) {
        boolean unconfirmed = !tracks.status("stop", atS).isEmpty();
        boolean lost = tracks.status("connection", atS).equals("lost");
        return new RobotSummary(
                icon(atS, unconfirmed, lost),
                robot().make(),
                List.of(robot().label()),
                condition(atS),
                RobotSummary.problem(unconfirmed, lost, "", false).orElse(List.of()),
                tracks.status("owner", atS),
                "",
                bot.isConnected() ? BatteryLevel.of(name -> value(name, atS)) : BatteryLevel.UNKNOWN,
                OptionalInt.empty(),
                lost,
                unconfirmed);
    }

    private StateIcon icon(double atS, boolean unconfirmed, boolean lost) {
        if (unconfirmed) {
            return StateIcon.UNCONFIRMED;
        }
        if (bot.isConnected()) {
            return isMoving(atS) ? StateIcon.MOVING : StateIcon.STATIONARY;
        }
        return lost ? StateIcon.LOST : StateIcon.WAITING;
    }

    private String condition(double atS) {
        if (!isPresent(atS)) {
            return TEXTS.get("notInTeam");
        }
        return bot.isConnected() ? RobotSummary.motion(isMoving(atS)) : connection(tracks.status("connection", atS));
    }

    private boolean isMoving(double atS) {
        return tracks.number("moving", atS).orElse(0.0) > 0;
    }

    private Value value(String parameter, double atS) {
        return tracks.parameters().stream()
                .filter(known -> known.name().equals(parameter))
                .findFirst()
                .map(known -> tracks.value(known, atS))
                .orElseGet(() -> new Value.Unknown(""));
    }

    /** One line about the robot. */
    String status(double atS) {
        if (!isPresent(atS)) {
            return TEXTS.get("notInTeam");
        }
        Pose at = tracks.pose(atS);
        return String.join(", ", conditions(atS)) + "   "
                + TEXTS.get(
                        robot().estimates() ? "pose.about" : "pose",
                        Math.round(at.xMm()),
                        Math.round(at.yMm()),
                        Math.round(at.headingDeg()));
    }

    private List<String> conditions(double atS) {
        List<String> conditions = new ArrayList<>();
        conditions.add(connection(tracks.status("connection", atS)));
        if (bot.isConnected()) {
            conditions.add(TEXTS.get(isMoving(atS) ? "moving" : "stationary"));
        }
        String owner = tracks.status("owner", atS);
        if (!owner.isEmpty()) {
            conditions.add(owner);
        }
        return conditions;
    }

    private static String connection(String recorded) {
        return switch (recorded) {
            case "connected", "connecting", "lost", "closed" -> TEXTS.get(recorded);
            default -> TEXTS.get("new");
        };
    }

    @Override
    public void close() {
        bot.close();
    }
}
