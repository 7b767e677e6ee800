package majic.act;

import java.io.ObjectStreamField;
import java.io.Serializable;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Pose;
import majic.bot.Value;
import majic.nav.CurrentMap;
import majic.nav.Destination;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A behaviour: what a robot does by itself. A subclass implements {@link #behave()} and uses the robot {@link #bot}
 * there; all fields that are not transient are saved with the act.
 *
 * <p>An act runs once, on its own thread. It ends when {@link #behave()} returns or throws, or when {@link #end()} is
 * called: then the robot is sent a stop, every further use of {@link #bot} throws {@link MotionStopped}, and the thread
 * is interrupted, in that order. In every case {@link #ended(boolean)} is called at the end, without a robot.
 */
public abstract class MajicAct extends Thread implements Serializable {
    private static final long serialVersionUID = 1;
    private static final Logger LOG = System.getLogger(MajicAct.class.getName());

    private static final String NOT_STARTED = "an act has no robots before it is started";

    /** Farther obstacles are not looked for. */
    private static final double OBSTACLE_MM = 10_000;

    /**
     * No field of this class is saved: an act that is read from a file has no thread, no robot and no clock, and is not
     * started.
     */
    private static final ObjectStreamField[] serialPersistentFields = {};

    /**
     * The robot; null before the act is started. Once {@link #behave()} has ended, or the act was ended, every use of
     * it throws {@link MotionStopped}, on every thread.
     */
    protected transient volatile @Nullable BotControl bot;

    private transient volatile @Nullable ActRobots actRobots;
    private transient volatile @Nullable ActListener listener;
    private transient volatile @Nullable Throwable failure;
    private transient volatile @Nullable Throwable endingFailure;
    private transient volatile @Nullable CountDownLatch joined;
    private transient volatile boolean calledOff;
    private transient volatile boolean hasBehaved;

    /** Creates a behaviour that has no robot yet. Not called when a saved act is read. */
    protected MajicAct() {
        super("act");
    }

    /**
     * Returns the robots that the act needs; the first is the one it is loaded onto. Called when the act's file is
     * made, which stores the result, and again before the act starts; without a robot, on any thread.
     *
     * @return at least one role; unless overridden, any one robot
     */
    public List<Role> roles() {
        return List.of(Role.any(Role.ME));
    }

    /**
     * Returns the arguments that the act takes, with their present values as defaults. Called when the act's file is
     * made, which stores the result; without a robot, on any thread.
     *
     * @return possibly none; unless overridden, the fields marked with {@link Argument}
     * @throws ActException if such a field cannot be an argument
     */
    public List<ActArgument> arguments() {
        return ArgumentFields.of(this);
    }

    /**
     * Gives an argument a value; to be called before the act is started.
     *
     * @param name the argument's name, in any case of its letters
     * @param value in any unit that the argument takes; a number without unit is in the argument's
     * @throws ActException if the act has no such argument; the message lists those it has
     * @throws majic.bot.ParameterException if the value is not permitted; the message contains what would be right
     */
    public void setArgument(String name, Value value) {
        ArgumentFields.set(this, name, value);
    }

    /**
     * Controls the robot. Called once, on the thread of the act. May return at any time, use {@link #pause} between
     * motions, and throw any exception.
     */
    protected abstract void behave();

    /**
     * Cleans up. Called on the act's thread when the act has ended; it can no longer command its robots.
     *
     * @param cutShort true if the act was ended from outside or failed, false if {@link #behave()} returned
     */
    protected void ended(boolean cutShort) {}

    /**
     * Waits by the robot's clock. {@link Thread#sleep(long)}, in contrast, takes milliseconds and does not follow the
     * clock of a simulated lab.
     *
     * @param seconds the time to wait, s; zero or less returns at once
     * @throws MotionStopped if the act was ended meanwhile
     */
    protected final void pause(double seconds) {
        checkMayGoOn();
        ActRobots robots = actRobots;
        try {
            if (robots != null) {
                robots.clock().sleep(seconds);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        checkMayGoOn();
    }

    /** Throws if the act can no longer use its robot; only {@link #ended(boolean)} runs without one. */
    private void checkMayGoOn() {
        Thread current = Thread.currentThread();
        ActRobots robots = actRobots;
        boolean tidying = hasBehaved && current == this;
        if (current.isInterrupted() || (!tidying && robots != null && robots.revocation() != null)) {
            throw new MotionStopped("the act was ended");
        }
    }

    /**
     * Returns a further robot, by the role that {@link #roles()} gave it.
     *
     * @param role the act's word for it
     * @return the robot; every use throws once the act has ended
     * @throws BotException if the act has no such role, or no robots yet
     */
    protected final BotControl robot(String role) {
        return robots(role).get(0);
    }

    /**
     * Returns all robots of a role that {@link Role#orMore() may be several}.
     *
     * @param role the act's word for it
     * @return at least one, in the order they were named; every use throws once the act has ended
     * @throws BotException if the act has no such role, or no robots yet
     */
    protected final List<BotControl> robots(String role) {
        ActRobots robots = actRobots;
        if (robots == null) {
            throw new BotException(NOT_STARTED);
        }
        return robots.robots(role);
    }

    /**
     * Shows the user what the act is doing: beside the robot, among the messages and in the session log.
     *
     * @param words a few of them
     */
    protected final void say(String words) {
        ActListener listening = listener;
        if (listening != null) {
            listening.said(words);
        }
    }

    /**
     * Shows readings of all robots of the act as curves, in one window of their own, as the command {@code plot} does.
     * Returns at once.
     *
     * @param parameters at least one; those that a robot does not have are left out
     * @throws majic.bot.ParameterException if no robot of the act has one of them, or it is a word
     * @throws BotException if there is no window, or the act has no robots yet
     */
    protected final void plot(String... parameters) {
        listening().plot(List.of(parameters));
    }

    /**
     * Returns whether the robot would have room at a place: whether all of the map of the team within the radius of its
     * body is known to be free.
     *
     * @param xMm in the frame of the map, which is that of the robots' poses
     * @param yMm in the same frame
     * @return false also where nothing is known
     * @throws BotException if there is no map, or the act has no robot yet
     */
    protected final boolean free(double xMm, double yMm) {
        return map().isFree(xMm, yMm, robot(Role.ME).get("body").number());
    }

    /**
     * Returns how far the centre of the robot is from the nearest obstacle on the map of the team.
     *
     * @return mm; infinite if there is none within {@value #OBSTACLE_MM} mm
     * @throws BotException if there is no map, or the place of the robot on it is not known
     */
    protected final double distanceToObstacle() {
        OccupancyGrid map = map();
        Pose here = pose();
        return map.obstacleMm(here.xMm(), here.yMm(), OBSTACLE_MM);
    }

    private OccupancyGrid map() {
        return teamMap()
                .get()
                .map(NavigationMap::grid)
                .orElseThrow(
                        () -> new BotException(
                                "the team has no map; \"map start 2\" builds one with robot 2, and \"map open FILE\" opens one"));
    }

    private CurrentMap teamMap() {
        return listening().map();
    }

    private ActListener listening() {
        ActListener listening = listener;
        if (listening == null) {
            throw new BotException(NOT_STARTED);
        }
        return listening;
    }

    /**
     * Returns where the robot is.
     *
     * @return in the frame of the map of the team
     * @throws BotException if that is not known at present
     */
    protected final Pose pose() {
        return placed(robot(Role.ME));
    }

    /**
     * Returns where another robot of the team is. The act does not command it, and others may do so meanwhile.
     *
     * @param robot its number or its name
     * @return in the frame of the map of the team
     * @throws BotException if there is no such robot, or its place is not known at present
     */
    protected final Pose poseOf(String robot) {
        return placed(listening().teamMate(robot));
    }

    private static Pose placed(BotControl robot) {
        if (robot.get("placed") instanceof Value.Unknown) {
            throw new BotException("the place of " + robot.name()
                    + " on the map is not known; \"set pose\" or \"localize\" places it");
        }
        return new Pose(
                robot.get("x").number(),
                robot.get("y").number(),
                robot.get("heading").number());
    }

    private MajicBot robot(BotControl control) {
        ActRobots robots = actRobots;
        if (robots == null) {
            throw new BotException(NOT_STARTED);
        }
        return robots.robot(control);
    }

    /**
     * Drives to a place, around the walls of the map of the team, what the sensors see and the other robots; returns
     * when the robot is stationary again.
     *
     * @param xMm in the frame of the robot's poses
     * @param yMm in the same frame
     * @return the place that it has reached
     * @throws majic.bot.MotionFailed if there is no way, or something stands in the way for too long
     */
    protected final MotionReport goTo(double xMm, double yMm) {
        return goTo(robot(Role.ME), new Destination(xMm, yMm), Guard.NEVER);
    }

    /**
     * Drives to a place as {@link #goTo(double, double)} does, and turns to a heading there.
     *
     * @param xMm in the frame of the robot's poses
     * @param yMm in the same frame
     * @param headingDeg counterclockwise positive
     * @return the place that it has reached
     */
    protected final MotionReport goTo(double xMm, double yMm, double headingDeg) {
        return goTo(robot(Role.ME), new Destination(new Pose(xMm, yMm, headingDeg), true), Guard.NEVER);
    }

    /**
     * Drives to a place of the map of the team as {@link #goTo(double, double)} does.
     *
     * @param place its name
     * @return the place that it has reached
     * @throws BotException if there is no map, or no such place
     */
    protected final MotionReport goTo(String place) {
        return goTo(robot(Role.ME), new Destination(teamMap().place(place)), Guard.NEVER);
    }

    /**
     * Lets a robot of the act drive to a place as {@link #goTo(double, double)} does.
     *
     * @param robot {@link #bot}, or one of {@link #robots}
     * @param destination in the frame of the robot's poses
     * @param until ends the motion early
     * @return the place that it has reached
     */
    protected final MotionReport goTo(BotControl robot, Destination destination, Guard until) {
        return teamMap().navigator().goTo(robot(robot), robot, destination, until);
    }

    /**
     * Drives where the map that the robot builds is unknown, until nothing is left that it can reach. If the team has
     * no map, the robot begins one.
     *
     * @return how many frontiers of the map were explored, and how much floor the map has
     * @throws BotException if the robot has no range sensors, or there is a map that no robot builds
     */
    protected final MotionReport explore() {
        BotControl me = robot(Role.ME);
        return teamMap().explore(robot(me), me, Guard.NEVER);
    }

    /**
     * Gives the act its robot and starts it, outside of any session; returns once the act's thread is registered with
     * the robot's clock. Notes of the act go to the log.
     *
     * @param robot connected; must not be commanded by other code meanwhile
     * @throws IllegalThreadStateException if it was started before
     * @throws BotException if it needs another robot, or several, or the system has no thread for it
     */
    public final void start(MajicBot robot) {
        List<Role> wanted = roles();
        if (wanted.size() > 1) {
            throw new BotException("the act needs " + wanted.size() + " robots: " + wanted);
        }
        wanted.get(0).unfit(robot).ifPresent(why -> {
            throw new BotException("the robot " + why);
        });
        start(new ActRobots(Map.of(Role.ME, List.of(robot))), new ActListener() {
            private final CurrentMap map = new CurrentMap((bot, news) -> {});

            @Override
            public CurrentMap map() {
                return map;
            }

            @Override
            public void said(String words) {
                LOG.log(Level.INFO, "{0}: {1}", getName(), words);
            }

            @Override
            public void ended() {
                warn(failure, " failed");
                warn(endingFailure, " failed in its ended()");
            }
        });
    }

    private void warn(@Nullable Throwable reason, String how) {
        if (reason != null && !(reason instanceof MotionStopped)) {
            LOG.log(Level.WARNING, getName() + how, reason);
        }
    }

    /** Starts the act with all its robots; returns once its thread is registered with the clock of its own robot. */
    final void start(ActRobots robots, ActListener listening) {
        if (getState() != State.NEW) {
            throw new IllegalThreadStateException("an act runs only once");
        }
        CountDownLatch begun = new CountDownLatch(1);
        joined = begun;
        actRobots = robots;
        listener = listening;
        bot = robots.robots(Role.ME).get(0);
        if (calledOff) {
            robots.revoke();
        }
        setDaemon(true);
        setName("act " + getClass().getSimpleName());
        setContextClassLoader(getClass().getClassLoader());
        try {
            super.start();
        } catch (OutOfMemoryError e) {
            throw new BotException("the system has no thread left for the act; end another program and try again", e);
        }
        awaitQuietly(begun);
    }

    private static void awaitQuietly(CountDownLatch begun) {
        try {
            begun.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Ends the act from outside: revokes its use of the robots, halts them, then interrupts the thread. From the start
     * of this call, no command of the act reaches a robot. Blocks as long as the slowest robot's stop does; may be
     * called again, and from any thread. An act that is ended before its start does nothing when started.
     */
    public final void end() {
        calledOff = true;
        ActRobots robots = actRobots;
        if (robots != null) {
            robots.revoke();
            robots.halt();
        }
        interrupt();
    }

    /** Returns why the act failed or was ended from outside; null if it completed or is still running. */
    final @Nullable Throwable failure() {
        return failure;
    }

    /** Returns the exception that {@link #ended(boolean)} threw; null if it threw none, or was not called yet. */
    final @Nullable Throwable endingFailure() {
        return endingFailure;
    }

    /**
     * Not supported: an act is started with its robot, by {@link #start(MajicBot)} or by a session.
     *
     * @throws IllegalStateException always
     */
    @Override
    public final void start() {
        throw new IllegalStateException("an act is started with its robot");
    }

    /** Runs the behaviour; called only by the start of the thread. */
    @Override
    public final void run() {
        ActRobots robots = actRobots;
        ActListener listening = listener;
        CountDownLatch begun = joined;
        if (robots == null || listening == null || begun == null) {
            throw new IllegalStateException("an act is started with its robot");
        }
        TimeSource.Membership membership = () -> {};
        try {
            membership = join(robots.clock(), begun);
            boolean cutShort = !behaveToTheEnd(robots);
            hasBehaved = true;
            tidyUp(cutShort);
        } catch (Throwable e) {
            failure = e;
        } finally {
            try {
                listening.ended();
            } finally {
                membership.close();
            }
        }
    }

    private static TimeSource.Membership join(TimeSource clock, CountDownLatch begun) {
        try {
            return clock.join();
        } finally {
            begun.countDown();
        }
    }

    /**
     * Revokes the use of the robots and halts them, whatever the author's code throws, including undeclared exceptions.
     */
    private boolean behaveToTheEnd(ActRobots robots) {
        try {
            if (robots.revocation() == null) {
                behave();
            }
            failure = robots.revocation();
        } catch (Throwable e) {
            BotException taken = robots.revocation();
            failure = taken == null ? e : taken;
        } finally {
            if (robots.revoke()) {
                robots.halt();
            }
        }
        return failure == null;
    }

    private void tidyUp(boolean cutShort) {
        try {
            ended(cutShort);
        } catch (Throwable e) {
            endingFailure = e;
        }
    }
}
