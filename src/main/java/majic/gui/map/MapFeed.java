package majic.gui.map;

import java.awt.geom.Rectangle2D;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.gui.kit.EventThread;
import majic.lab.LabAccess;
import majic.lab.LabAccess.Wall;
import majic.nav.CurrentMap;
import majic.nav.Navigator;
import majic.nav.Wait;
import majic.nav.grid.NavigationMap;
import majic.panel.RefreshTicks;
import majic.panel.map.Trail;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majic.team.TeamListener;
import majic.text.LateLogger;
import org.jspecify.annotations.Nullable;

/**
 * Builds what the team map shows, ten times a second on its own thread, because a query to a lab may block. Only
 * changed scenes are passed on.
 */
public final class MapFeed implements TeamListener, AutoCloseable {
    private static final Logger LOG = LateLogger.of(MapFeed.class);

    /** Distance at which robots are drawn from each other when their positions are unknown. */
    private static final double GUESSED_APART_MM = 1000;

    /** The time until the window is visible, which the first update would delay. */
    private static final int FIRST_UPDATE_MS = 300;

    private final Team team;
    private final BotFactory factory;
    private final CurrentMap map;
    private final Consumer<MapScene> show;
    private final Map<Member, Start> starts = new ConcurrentHashMap<>();
    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(MapFeed::thread);
    private MapScene last = MapScene.EMPTY;
    private @Nullable MapPicture picture;

    /**
     * Where a robot's own frame lies in the room's frame, and the robot's trail.
     *
     * @param known whether the origin is known; otherwise it is a place beside the room
     * @param inLab whether the lab has its true pose
     * @param placed where the user has placed the robot; null if the origin does not come from that
     * @param walls the room at that time
     */
    private record Start(
            Pose origin,
            boolean known,
            boolean inLab,
            @Nullable Pose placed,
            List<Wall> walls,
            Trail trail) {
        /** With the trail before a correction of the pose; a line that no robot can drive is a jump in it. */
        Start with(Trail before) {
            return new Start(origin, known, inLab, placed, walls, before);
        }

        /** Whether it still holds; one beside the room does not in another room. */
        boolean holds(@Nullable Pose nowPlaced, List<Wall> nowWalls) {
            return Objects.equals(placed, nowPlaced) && (known || walls.equals(nowWalls));
        }
    }

    /**
     * Creates a feed; {@link #start()} starts it.
     *
     * @param show receives each new scene, on the event dispatch thread
     */
    public MapFeed(Team team, BotFactory factory, CurrentMap map, Consumer<MapScene> show) {
        this.team = team;
        this.factory = factory;
        this.map = map;
        this.show = show;
    }

    public void start() {
        team.addListener(this);
        clock.scheduleWithFixedDelay(this::update, FIRST_UPDATE_MS, RefreshTicks.PERIOD_MS, TimeUnit.MILLISECONDS);
    }

    /** Records where the robot is when it is added, before it moves. */
    @Override
    public void added(Member member) {
        start(member);
    }

    @Override
    public void removed(Member member) {
        starts.remove(member);
    }

    @Override
    public void close() {
        team.removeListener(this);
        clock.shutdownNow();
    }

    private static Thread thread(Runnable body) {
        Thread thread = new Thread(body, "team map");
        thread.setDaemon(true);
        return thread;
    }

    private void update() {
        try {
            MapScene scene = scene();
            if (!scene.equals(last)) {
                last = scene;
                EventThread.later(() -> show.accept(scene));
            }
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "the team map could not be brought up to date", e);
        }
    }

    MapScene scene() {
        @Nullable LabAccess lab = factory.lab().orElse(null);
        Map<String, Pose> truths = lab == null ? Map.of() : lab.truePoses();
        Map<String, Pose> strangers = new LinkedHashMap<>(truths);
        List<MapScene.Robot> robots = new ArrayList<>();
        boolean guessed = false;
        for (Member member : team.members()) {
            Start start = start(member);
            guessed |= !start.known;
            robots.add(robot(member, start, truths));
            if (start.inLab) {
                strangers.remove(nameInLab(member));
            }
        }
        return new MapScene(
                lab == null ? List.of() : lab.walls(),
                lab == null ? LabAccess.Furnishing.NONE : lab.furnishing(),
                robots,
                bystanders(strangers),
                picture(),
                guessed);
    }

    private @Nullable MapPicture picture() {
        NavigationMap now = map.get().orElse(null);
        MapPicture shown = picture;
        if (now == null) {
            picture = null;
        } else if (shown == null || !shown.shows(now)) {
            picture = new MapPicture(now);
        }
        return picture;
    }

    private static List<MapScene.Bystander> bystanders(Map<String, Pose> strangers) {
        return strangers.entrySet().stream()
                .map(entry -> new MapScene.Bystander(entry.getKey(), entry.getValue()))
                .toList();
    }

    private MapScene.Robot robot(Member member, Start start, Map<String, Pose> truths) {
        Pose reported = start.origin.plus(member.bot().state().pose());
        start.trail.add(reported);
        return new MapScene.Robot(
                        member.number(),
                        member.label(),
                        member.bot().profile().bodyMm(),
                        start.origin,
                        reported,
                        member.bot().uncertainty(),
                        start.inLab ? truths.get(nameInLab(member)) : null,
                        start.trail,
                        member.bot().isConnected(),
                        team.stopStatus().problem(member.number()).isPresent(),
                        way(member.bot(), start.origin))
                .at(member.bot().heightMm().orElse(0));
    }

    /** Returns the way of a robot; its first point is where the robot is. */
    private MapScene.PlannedWay way(MajicBot robot, Pose origin) {
        Navigator navigator = map.navigator();
        Optional<Wait> wait = navigator.waits(robot);
        return navigator
                .way(robot)
                .map(way -> new MapScene.PlannedWay(
                        way.points().stream().skip(1).map(origin::plus).toList(),
                        navigator.reserved(robot).stream().map(origin::plus).toList(),
                        wait.map(Wait::why).orElse(""),
                        wait.flatMap(Wait::other).map(this::number).orElse(OptionalInt.empty())))
                .orElse(MapScene.PlannedWay.NONE);
    }

    private OptionalInt number(MajicBot robot) {
        return team.members().stream()
                .filter(member -> member.bot() == robot)
                .mapToInt(Member::number)
                .findFirst();
    }

    private String nameInLab(Member member) {
        return factory.nameInLab(member.bot()).orElse("");
    }

    /**
     * Returns the start of a robot. It is determined again when the robot was placed, and one beside the room when a
     * lab with another room starts.
     */
    private Start start(Member member) {
        List<Wall> walls = factory.lab().map(LabAccess::walls).orElse(List.of());
        Pose placed = member.bot().placedAt().orElse(null);
        return Objects.requireNonNull(starts.compute(member, (key, start) -> {
            if (start != null && start.holds(placed, walls)) {
                return start;
            }
            Start anew = startOf(member, placed, walls);
            return start != null && start.placed != null && anew.placed != null ? anew.with(start.trail) : anew;
        }));
    }

    private Start startOf(Member member, @Nullable Pose placed, List<Wall> walls) {
        Pose truth = factory.lab()
                .filter(lab -> lab.time() == member.time())
                .map(lab -> lab.truePoses().get(nameInLab(member)))
                .orElse(null);
        if (placed != null) {
            return new Start(Pose.START, true, truth != null, placed, walls, new Trail());
        }
        if (truth == null) {
            return new Start(besideRoom(member.number() - 1, walls), false, false, null, walls, new Trail());
        }
        return new Start(truth.originOf(member.bot().state().pose()), true, true, null, walls, new Trail());
    }

    /**
     * Returns a place for a robot whose start is not known: in columns to the right of the room, clear of its walls.
     */
    private static Pose besideRoom(int index, List<Wall> walls) {
        if (walls.isEmpty()) {
            return new Pose(0, -index * GUESSED_APART_MM, 0);
        }
        Rectangle2D room =
                new Rectangle2D.Double(walls.get(0).x1(), walls.get(0).y1(), 0, 0);
        walls.forEach(wall -> {
            room.add(wall.x1(), wall.y1());
            room.add(wall.x2(), wall.y2());
        });
        int rows = Math.max(1, (int) (room.getHeight() / GUESSED_APART_MM));
        return new Pose(
                room.getMaxX() + (1 + index / rows) * GUESSED_APART_MM,
                room.getMaxY() - (0.5 + index % rows) * GUESSED_APART_MM,
                0);
    }
}
