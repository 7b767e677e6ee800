package majic.nav;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.Pose;
import majic.nav.file.MapFiles;
import majic.nav.grid.LikelihoodField;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import org.jspecify.annotations.Nullable;

/**
 * The map of a team: opened from a file, or built by a robot while it drives. Its frame is that of the robots' poses,
 * and it keeps the places of the robots that it follows right. Thread-safe.
 */
public final class CurrentMap {
    private static final double LAST_S = 30;
    private static final String PLACE = "map place";
    private static final double MM_PER_M = 1000;

    private @Nullable NavigationMap map;
    private final Map<MajicBot, LiveMapping> mappings = new LinkedHashMap<>();

    /** What each robot has drawn of the map that is built. */
    private final Map<MajicBot, OccupancyGrid> parts = new LinkedHashMap<>();

    private boolean unsaved;
    private @Nullable Path file;
    private @Nullable Distances distances;
    private final BiConsumer<MajicBot, String> news;
    private final Function<MajicBot, Optional<Pose>> standing;
    private final Navigator navigator = new Navigator(this::get);
    private final Map<MajicBot, LiveLocalisation> localised = new ConcurrentHashMap<>();

    /** Whether robots can be found on the map: there is one, and none builds it. */
    private volatile boolean stands;

    private final BotListener watch = new BotListener() {
        @Override
        public void stateChanged(MajicBot bot, BotState state) {
            if (stands && !localised.containsKey(bot) && canBeTracked(bot)) {
                bot.time().runAsync("localisation", () -> track(bot));
            }
        }

        @Override
        public void connectionChanged(MajicBot bot, MajicBot.Connection now) {
            if (now == MajicBot.Connection.LOST || now == MajicBot.Connection.CLOSED) {
                endLocalisation(bot);
                bot.time().runAsync("end of mapping", () -> endIfMappedBy(bot));
            }
        }
    };

    /**
     * No map.
     *
     * @param news receives what happens to a robot that is followed or builds the map, as the rest of a sentence that
     *     begins with its name; on a thread of its own, and must return soon
     */
    public CurrentMap(BiConsumer<MajicBot, String> news) {
        this(news, robot -> Optional.empty());
    }

    /**
     * No map.
     *
     * @param news as in the other constructor
     * @param standing where a robot that was not placed stands in the frame of the map; empty for where its poses have
     *     it
     */
    public CurrentMap(BiConsumer<MajicBot, String> news, Function<MajicBot, Optional<Pose>> standing) {
        this.news = news;
        this.standing = standing;
    }

    /**
     * Keeps the place of a robot right from now on, if it has range sensors: whenever there is a map that no robot
     * builds at the moment and the robot is placed, its place is corrected by what it measures. That never changes a
     * motion, which goes by the odometry.
     *
     * @param robot any
     */
    public void follow(MajicBot robot) {
        robot.addListener(watch);
        navigator.add(robot);
    }

    /**
     * Corrects the place of a robot no longer.
     *
     * @param robot one that was followed
     */
    public void unfollow(MajicBot robot) {
        robot.removeListener(watch);
        navigator.remove(robot);
        endLocalisation(robot);
    }

    /**
     * Looks for a robot everywhere on the map. Until it is found its place is unknown; for that it has to drive some
     * metres. A robot of another program is looked for there, on the map of that program; may block for some seconds.
     *
     * @param robot connected, one that is followed
     * @throws BotException if it has no range sensors, there is no map, or a robot builds it at the moment
     */
    public void localize(MajicBot robot) {
        if (robot.rangeSensors().isEmpty()) {
            throw new BotException("localize: " + robot.name()
                    + " has no range sensors; \"set pose\" places it, or dragging it on the map");
        }
        Optional<Runnable> elsewhere = robot.remoteLocalization();
        if (elsewhere.isEmpty()) {
            search(robot);
        } else {
            refuseWhileMappedBy(robot);
            elsewhere.get().run();
        }
    }

    /** The place of a robot that builds the map is that of the map. */
    private synchronized void refuseWhileMappedBy(MajicBot robot) {
        if (mappings.containsKey(robot)) {
            refuseWhileMapping("localize");
        }
    }

    private synchronized void search(MajicBot robot) {
        NavigationMap known = present("localize");
        refuseWhileMapping("localize");
        LiveLocalisation running = localised.get(robot);
        if (running == null) {
            begin(robot, known, true);
        } else {
            running.search();
        }
    }

    private synchronized void track(MajicBot robot) {
        if (stands && map != null && !localised.containsKey(robot) && canBeTracked(robot)) {
            begin(robot, map, false);
        }
    }

    private static boolean canBeTracked(MajicBot robot) {
        return robot.isConnected()
                && robot.remoteLocalization().isEmpty()
                && robot.uncertainty().isKnown()
                && !robot.rangeSensors().isEmpty();
    }

    private void begin(MajicBot robot, NavigationMap known, boolean search) {
        if (distances == null) {
            distances = new Distances(known.grid());
        }
        LiveLocalisation begun = new LiveLocalisation(
                robot,
                navigator.space(),
                distances::get,
                search,
                text -> news.accept(robot, text),
                () -> localised.remove(robot));
        localised.put(robot, begun);
        begun.begin();
    }

    /** The distances from the walls of a map, computed when they are needed, once for all robots. */
    private static final class Distances {
        private final OccupancyGrid grid;
        private @Nullable LikelihoodField made;

        Distances(OccupancyGrid grid) {
            this.grid = grid;
        }

        synchronized LikelihoodField get() {
            LikelihoodField field = made == null ? new LikelihoodField(grid) : made;
            made = field;
            return field;
        }
    }

    private void endLocalisation(MajicBot robot) {
        LiveLocalisation ending = localised.remove(robot);
        if (ending != null) {
            ending.end();
        }
    }

    /** Sets another map, or none; robots are tracked anew if it stands. */
    private void change(@Nullable NavigationMap now, boolean changed) {
        List.copyOf(localised.keySet()).forEach(this::endLocalisation);
        map = now;
        distances = null;
        unsaved = changed;
        file = null;
        stands = now != null && mappings.isEmpty();
    }

    /** Returns what sends robots to places on this map, around the robots that it follows. */
    public Navigator navigator() {
        return navigator;
    }

    /** Returns the map as it is now; empty if there is none. */
    public synchronized Optional<NavigationMap> get() {
        return Optional.ofNullable(map);
    }

    /** Returns the file that the map was opened from or saved in last; empty if it is another one since. */
    public synchronized Optional<Path> file() {
        return Optional.ofNullable(unsaved ? null : file);
    }

    /** Returns the robots that build the map at the moment, in the order in which they began. */
    public synchronized List<MajicBot> mappedBy() {
        return List.copyOf(mappings.keySet());
    }

    /**
     * Opens a map instead of the one there is. Blocks.
     *
     * @param file as {@link MapFiles#read} takes it
     * @throws IOException as there
     * @throws BotException if a robot builds a map at the moment, or the one there is has not been saved
     */
    public void open(Path file) throws IOException {
        NavigationMap opened = MapFiles.read(file);
        synchronized (this) {
            refuseToReplace("map open");
            change(opened, false);
            this.file = file.toAbsolutePath();
        }
    }

    /**
     * Removes the map.
     *
     * @throws BotException if a robot builds it at the moment
     */
    public synchronized void close() {
        refuseWhileMapping("map close");
        change(null, false);
    }

    private void refuseToReplace(String command) {
        refuseWhileMapping(command);
        if (unsaved) {
            throw new BotException(
                    command + ": the map is not saved; \"map save FILE\" keeps it, \"map close\" drops it");
        }
    }

    private void refuseWhileMapping(String command) {
        if (!mappings.isEmpty()) {
            throw new BotException(command + ": " + builders() + " the map at the moment; \"map stop\" ends that");
        }
    }

    private String builders() {
        return mappings.keySet().stream().map(MajicBot::name).collect(Collectors.joining(" and "))
                + (mappings.size() == 1 ? " builds" : " build");
    }

    /**
     * Begins a new map that a robot builds while it drives, in the background, or lets a further robot build the one
     * that is being built. The robot's pose at the first scan is taken as right; later the robot is placed where its
     * own scans have it. May block for half a second. It ends with {@link #stop}, and when the connection of a robot
     * that is followed is lost or closed.
     *
     * @param robot connected, one that is followed; a further one has to be placed on the map
     * @throws BotException if it has no range sensors or builds the map already, if the place of a further robot is not
     *     known, or the map there is has not been saved
     */
    public void start(MajicBot robot) {
        if (robot.rangeSensors().isEmpty()) {
            throw new BotException("map start: " + robot.name()
                    + " has no range sensors; a robot with a laser scanner or sonars would be right");
        }
        Optional<Pose> place = standing.apply(robot);
        LiveMapping begun;
        synchronized (this) {
            refuseToStart(robot, place);
            begun = mappingOf(robot);
            if (mappings.isEmpty()) {
                parts.clear();
                change(null, false);
            }
            mappings.put(robot, begun);
            stands = false;
        }
        if (robot.placedAt().isEmpty()) {
            robot.place(place.orElse(robot.state().pose()));
        }
        begun.begin();
    }

    private void refuseToStart(MajicBot robot, Optional<Pose> place) {
        if (mappings.isEmpty()) {
            refuseToReplace("map start");
        } else if (mappings.containsKey(robot)) {
            throw new BotException("map start: " + robot.name() + " builds the map already");
        } else if (place.isEmpty() && !robot.uncertainty().isKnown()) {
            throw new BotException("map start: " + builders() + " the map, and the place of " + robot.name()
                    + " on it is not known; \"set pose\" places it, or dragging it on the team map");
        }
    }

    /**
     * Lets a robot drive where the map that it builds is unknown, and returns when it can reach no such place. If there
     * is no map, the robot begins one; if other robots build one, it joins them, and they share the work.
     *
     * @param robot as in {@link #start}
     * @param control commands that robot
     * @param until ends the motion early
     * @return how many frontiers of the map were explored, and how much floor the map has
     * @throws BotException as in {@link #start}, if there is a map that no robot builds, or as for any motion
     */
    public MotionReport explore(MajicBot robot, BotControl control, Guard until) {
        if (!isMappedBy(robot)) {
            refuseToExploreFinished(robot);
            start(robot);
        }
        try (Exploration course = new Exploration(robot, navigator, () -> isMappedBy(robot))) {
            return control.follow(course, until);
        }
    }

    private synchronized boolean isMappedBy(MajicBot robot) {
        return mappings.containsKey(robot);
    }

    private synchronized void refuseToExploreFinished(MajicBot robot) {
        if (map != null && mappings.isEmpty()) {
            throw new BotException("explore: " + robot.name()
                    + " does not build the map that there is; \"map start ROBOT\" lets it begin a new one");
        }
    }

    private LiveMapping mappingOf(MajicBot robot) {
        try {
            return new LiveMapping(robot, navigator.space(), grid -> draw(robot, grid), () -> failed(robot));
        } catch (NoClassDefFoundError e) {
            throw new BotException(
                    "map start: the library EJML is missing; org.ejml:ejml-dsparse on the class path would be right",
                    e);
        }
    }

    private void failed(MajicBot robot) {
        news.accept(robot, "builds the map no longer because of an error in MAJIC; the log has it");
        robot.time().runAsync("end of mapping", () -> endIfMappedBy(robot));
    }

    private synchronized void draw(MajicBot robot, OccupancyGrid grid) {
        if (mappings.containsKey(robot)) {
            parts.put(robot, grid);
            OccupancyGrid all =
                    parts.values().stream().reduce(OccupancyGrid::joined).orElse(grid);
            map = map == null ? NavigationMap.of(all) : map.with(all);
            unsaved = true;
        }
    }

    /**
     * Ends building the map, which stays. Blocks until the last scan is in it, some seconds for a large map. Has no
     * effect if no robot builds one.
     */
    public void stop() {
        mappedBy().forEach(this::endIfMappedBy);
    }

    private void endIfMappedBy(MajicBot robot) {
        LiveMapping ending;
        synchronized (this) {
            ending = mappings.get(robot);
        }
        if (ending == null) {
            return;
        }
        ending.end(LAST_S);
        synchronized (this) {
            mappings.remove(robot, ending);
            stands = map != null && mappings.isEmpty();
        }
    }

    /**
     * Gives a place a name, instead of the one that had it.
     *
     * @param place on the map
     * @throws BotException if there is no map
     */
    public synchronized void add(NavigationMap.Place place) {
        map = present(PLACE).with(place);
        unsaved = true;
    }

    /**
     * Removes a place.
     *
     * @param name of the place, whatever the case
     * @throws BotException if there is no map, or no such place
     */
    public synchronized void remove(String name) {
        place(name);
        map = present(PLACE).without(name);
        unsaved = true;
    }

    /**
     * Gives a place another name.
     *
     * @param name its present one, whatever the case
     * @param now the new one; a place that had it is removed
     * @throws BotException if there is no map, or no such place
     */
    public synchronized void rename(String name, String now) {
        NavigationMap.Place place = place(name);
        map = present(PLACE).without(name).with(new NavigationMap.Place(now, place.pose(), place.withHeading()));
        unsaved = true;
    }

    /**
     * Looks up where a place of the map is.
     *
     * @param name whatever the case
     * @return empty if there is no map, or no such place
     */
    public synchronized Optional<Pose> whereIs(String name) {
        return map == null
                ? Optional.empty()
                : map.places().stream()
                        .filter(place -> place.name().equalsIgnoreCase(name))
                        .map(NavigationMap.Place::pose)
                        .findFirst();
    }

    /**
     * Returns a place of the map.
     *
     * @param name whatever the case
     * @return the place
     * @throws BotException if there is no map, or no such place; the message names those that there are
     */
    public synchronized NavigationMap.Place place(String name) {
        NavigationMap here = present(name);
        return here.place(name)
                .orElseThrow(() -> new BotException(name + ": there is no such place on the map; there "
                        + (here.places().isEmpty()
                                ? "are none"
                                : "are "
                                        + here.places().stream()
                                                .map(NavigationMap.Place::name)
                                                .collect(Collectors.joining(", ")))));
    }

    private synchronized NavigationMap present(String command) {
        if (map == null) {
            throw new BotException(
                    command + ": there is no map; \"map start 2\" begins one with robot 2, and \"map open"
                            + " FILE\" opens one");
        }
        return map;
    }

    /**
     * Writes the map with its places, as {@link MapFiles#write} does. Blocks.
     *
     * @param yaml the name of the file
     * @throws IOException if a file cannot be written
     * @throws BotException if there is no map
     */
    public void save(Path yaml) throws IOException {
        NavigationMap written = present("map save");
        MapFiles.write(yaml, written);
        synchronized (this) {
            unsaved &= map != written;
            file = map == written ? yaml.toAbsolutePath() : file;
        }
    }

    /** Returns what is known of the map, in a line. */
    public synchronized String text() {
        String size = map == null ? "no map yet" : size(map);
        if (mappings.isEmpty()) {
            return map == null ? "there is no map" : size;
        }
        int scans = mappings.values().stream().mapToInt(LiveMapping::scans).sum();
        int loops = mappings.values().stream().mapToInt(LiveMapping::loops).sum();
        return size + "; " + builders() + " it: " + counted(scans, "scan") + ", " + counted(loops, "loop");
    }

    private static String counted(int count, String what) {
        return count + " " + what + (count == 1 ? "" : "s");
    }

    private static String size(NavigationMap map) {
        OccupancyGrid grid = map.grid();
        return String.format(
                Locale.ROOT,
                "%.1f by %.1f m, cells of %.0f mm, %s",
                grid.width() * grid.cellMm() / MM_PER_M,
                grid.height() * grid.cellMm() / MM_PER_M,
                grid.cellMm(),
                counted(map.places().size(), "place"));
    }
}
