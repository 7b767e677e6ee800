package majic.team;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.driver.BotDriver;
import majic.time.OrderedEvents;
import majic.time.Signal;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * The robots by number, and the STOP for all of them. All commands to robots, from a window, a console or a test, pass
 * through this class. Thread-safe.
 */
public final class Team implements AutoCloseable {
    /** How many robots there may be unless set otherwise. */
    public static final int MAX_BOTS = 20;

    /** How many robots there may be at most. */
    public static final int MOST_BOTS = 1000;

    /** How long {@link #close()} waits for all robots, seconds. */
    private static final double CLOSE_BOUND_S = 2.5;

    /** How long a stop waits for owners and listeners once it has been sent, ms; longer only if one of them blocks. */
    private static final int CALLBACK_BOUND_MS = 500;

    private final TimeSource time;
    private final Signal changes;
    private final TeamEvents events;
    private final Roster roster;
    private final Object latching = new Object();
    private final StopCount stops = new StopCount();
    private final StopReceipts stopReceipts;
    private final StopSender stopSender;
    private volatile boolean latched;
    private volatile @Nullable StopOrigin stopOrigin;
    private volatile @Nullable SharedStop sharedStop;

    /** What the programs that share STOP have not received yet. */
    private final OrderedEvents sharing = new OrderedEvents();

    /**
     * Creates an empty team of at most {@link #MAX_BOTS} robots.
     *
     * @param time the clock of scripts and of waits for robots: the lab's, if there is one
     */
    public Team(TimeSource time) {
        this(time, MAX_BOTS);
    }

    /**
     * Creates an empty team.
     *
     * @param time the clock of scripts and of waits for robots
     * @param maxBots how many robots there may be, 1 to {@value #MOST_BOTS}
     * @throws IllegalArgumentException if it is outside of that range
     */
    public Team(TimeSource time, int maxBots) {
        if (maxBots < 1 || maxBots > MOST_BOTS) {
            throw new IllegalArgumentException("a team has room for 1 to " + MOST_BOTS + " robots, not " + maxBots);
        }
        this.time = time;
        this.changes = time.signal();
        this.events = new TeamEvents(time, changes);
        this.roster = new Roster(maxBots);
        this.stopReceipts = new StopReceipts(events, roster);
        this.stopSender = new StopSender(events, stopReceipts);
    }

    /**
     * Adds a robot.
     *
     * @param bot a connected robot
     * @param wanted its number; empty for the lowest that was never used
     * @return the new member
     * @throws BotException if the number is taken or out of range, the team is full, or the robot's driver does not
     *     extend {@link BotDriver}; the robot was not added
     */
    public Member add(MajicBot bot, OptionalInt wanted) {
        BotDriver driver = BotDriver.of(bot);
        Member member = roster.add(wanted, number -> newMember(number, driver));
        bot.addListener(new MemberListener(events, member, stopSender));
        member.start();
        events.publish(listener -> listener.added(member));
        return member;
    }

    /**
     * Latches a robot that joins during a STOP: either STOP includes the new robot, or this method finds it latched.
     */
    private Member newMember(int number, BotDriver bot) {
        Member member = new Member(number, bot, events, this::isLatched);
        bot.join(member, "robot " + number + " (" + bot.type().label() + ")");
        if (latched) {
            bot.latch();
        }
        return member;
    }

    /**
     * Checks whether a robot could be added, before connecting to it.
     *
     * @param wanted its number; empty for the lowest that was never used
     * @throws BotException what {@link #add} would throw now
     */
    public void checkRoom(OptionalInt wanted) {
        roster.number(wanted);
    }

    /**
     * Stops a robot, ends whatever runs on it, closes it and removes it. Blocks for about a second at most.
     *
     * @param number its number
     * @throws BotException if there is no such robot
     */
    public void remove(int number) {
        Member member = member(number);
        Leases.Stopped stopped = member.beginStop(null);
        boolean wasMember = roster.remove(member);
        member.close();
        member.endStop();
        notifyAfterStop(List.of(stopped), () -> {
            if (wasMember) {
                events.publish(listener -> listener.removed(member));
            }
            stopReceipts.removed();
            stopReceipts.publish();
            member.endStop();
        });
    }

    /**
     * Gives a robot a name, or another one, or takes it away. Commands may use it in place of the number.
     *
     * @param member a robot of this team
     * @param name a letter, then letters, digits and underscores, at most 20 characters in all; empty for no name
     * @throws BotException if it cannot be a name, or another robot has it, in whatever case; nothing has changed
     */
    public void rename(Member member, String name) {
        roster.rename(member, name);
        events.publish(listener -> listener.renamed(member));
    }

    /**
     * Returns a robot by its number.
     *
     * @param number its number
     * @return the member
     * @throws BotException if there is none; the message lists those there are
     */
    public Member member(int number) {
        return roster.member(number);
    }

    /**
     * Returns all robots.
     *
     * @return a snapshot, by number
     */
    public List<Member> members() {
        return roster.all();
    }

    /**
     * Returns how many robots there may be, which is also the highest number.
     *
     * @return the number passed to the constructor, or {@link #MAX_BOTS}
     */
    public int maxBots() {
        return roster.maxBots();
    }

    /**
     * Lists the robots as text.
     *
     * @return for instance {@code robots: 1 Rex (Aibo), 2 Pioneer}
     */
    public String listing() {
        return listing(members());
    }

    /**
     * Lists some robots as text.
     *
     * @param all the robots
     * @return as {@link #listing()} for the whole team
     */
    public static String listing(List<Member> all) {
        return Roster.words(all);
    }

    /**
     * Stops some robots: ends their motions, empties their queues, ends the acts and scripts that own them. Owners and
     * listeners are called on other threads, once the stops are being written to all connections. Returns when they
     * have returned, after {@value #CALLBACK_BOUND_MS} ms at most. Later commands wait until the robot has stopped and
     * the listeners have returned. Each robot is answered: {@code done} when it has confirmed its stop and the owner
     * that was ended has given it back.
     *
     * @param chosen which robots
     * @param by the source of the stop, which is not ended by it; null for a user
     */
    public void stop(Collection<Member> chosen, @Nullable Owner by) {
        List<Member> stopped = List.copyOf(chosen);
        if (by != null) {
            stop(stopped, by, false, () -> {});
        } else {
            stops.stopped(stopped);
            stop(stopped, null, false, announcement(stopped));
        }
    }

    /** STOP: as {@link #stop} for all robots, and no motion is accepted until {@link #release()}. */
    public void stopAll() {
        stopAll(null);
    }

    /**
     * STOP that was pressed elsewhere: as {@link #stopAll()}.
     *
     * @param origin is kept until {@link #release()} or the next STOP; null for a STOP of this program
     */
    public void stopAll(@Nullable StopOrigin origin) {
        latch(true, origin);
        stops.stoppedAll();
        List<Member> all = members();
        Runnable announcement = announcement(all);
        stop(all, null, true, () -> {
            events.deliver();
            announcement.run();
        });
    }

    /**
     * Sets whether STOP of this team stops robots of other programs too, so that it has robots to stop even while this
     * team has none, and is released by all of them.
     *
     * @param with the other programs; null for none, as in a new team
     */
    public void shareStop(@Nullable SharedStop with) {
        sharedStop = with;
    }

    /**
     * Reports whether the latched STOP has reached the programs that share it.
     *
     * @param problem why it has not, as a sentence; empty if it has
     */
    public void reportSharedStop(String problem) {
        stopReceipts.elsewhere(problem);
        stopReceipts.publish();
    }

    /**
     * STOP, if there is a robot here, or STOP is shared with other programs. Otherwise it ends what runs without
     * robots, and does not latch.
     *
     * @return whether it latched
     */
    public boolean stopAllIfAny() {
        if (members().isEmpty() && sharedStop == null) {
            stops.stoppedAll();
            changes.raise();
            return false;
        }
        stopAll();
        return true;
    }

    private Runnable announcement(List<Member> stopped) {
        long atNanos = time.nanos();
        return () -> events.publish(listener -> listener.stopped(stopped, atNanos));
    }

    /** Revokes, writes to every connection, then notifies. */
    private void stop(List<Member> members, @Nullable Owner by, boolean latches, Runnable announcement) {
        List<Leases.Stopped> stopped =
                members.stream().map(member -> member.beginStop(by)).toList();
        stopSender.send(members, latches);
        changes.raise();
        notifyAfterStop(stopped, () -> {
            announcement.run();
            members.forEach(Member::endStop);
            stopReceipts.publish();
        });
    }

    /**
     * Calls the programs that share STOP, owners and listeners on other threads, and waits briefly for them, so that
     * later work follows the calls.
     */
    private void notifyAfterStop(List<Leases.Stopped> stopped, Runnable afterwards) {
        List<Runnable> callbacks = new ArrayList<>();
        callbacks.add(sharing::deliver);
        stopped.forEach(one -> one.ended().forEach(owner -> callbacks.add(owner::endLoggingErrors)));
        callbacks.add(() -> {
            stopped.forEach(Leases.Stopped::answer);
            afterwards.run();
        });
        CountDownLatch running = new CountDownLatch(callbacks.size());
        for (Runnable callback : callbacks) {
            time.runAsync("notifying of a stop", () -> {
                try {
                    callback.run();
                } finally {
                    running.countDown();
                }
            });
        }
        try {
            running.await(CALLBACK_BOUND_MS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Allows motion again after STOP. Nothing resumes by itself, and a STOP that follows this call stays in force. If
     * STOP is shared with other programs, it is released for all of them or not at all; on a thread that may wait, this
     * method waits {@value #CALLBACK_BOUND_MS} ms at most until that is decided.
     */
    public void release() {
        SharedStop shared = sharedStop;
        if (shared == null) {
            releaseAlone();
            return;
        }
        AtomicBoolean decided = new AtomicBoolean();
        Runnable release = () -> shared.release(() -> {
            decided.set(true);
            changes.raise();
        });
        synchronized (latching) {
            sharing.put(release);
        }
        sharing.deliver();
        if (!WaitPolicy.isAllowed()) {
            return;
        }
        try {
            changes.await(decided::get, CALLBACK_BOUND_MS / 1000.0);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Releases STOP as {@link #release()}, for this team only: the programs that share it have been released. */
    public void releaseAlone() {
        latch(false, null);
        members().forEach(Member::release);
        stopReceipts.released();
        sharing.deliver();
        events.deliver();
    }

    /** Queues the event together with each change, so that listeners receive events in the order of the changes. */
    private void latch(boolean on, @Nullable StopOrigin origin) {
        synchronized (latching) {
            stopOrigin = origin;
            latched = on;
            events.put(listener -> listener.latchChanged(on));
            SharedStop shared = sharedStop;
            if (shared != null) {
                sharing.put(() -> shared.latchChanged(on));
            }
        }
    }

    /**
     * Returns how often robots were stopped by users.
     *
     * @return the counts; each stop is counted before it reaches a robot
     */
    public StopCount stops() {
        return stops;
    }

    /**
     * Returns whether every stop that a robot has confirmed was answered.
     *
     * @return false while an owner that a stop ended has not given its robot back, for 2.5 s at most
     */
    public boolean areStopsAnswered() {
        return stopSender.areAnswered();
    }

    /**
     * Returns which robots have confirmed their stops.
     *
     * @return a snapshot; listeners receive each change of it
     */
    public StopStatus stopStatus() {
        return stopReceipts.status();
    }

    /**
     * Returns whether STOP is latched.
     *
     * @return true from {@link #stopAll()} to {@link #release()}
     */
    public boolean isLatched() {
        return latched;
    }

    /**
     * Describes the STOP that is latched, for messages.
     *
     * @return a sentence with its origin, if it was pressed elsewhere
     */
    public String latchText() {
        return stopOrigin().map(StopOrigin::toString).orElse("STOP") + " is latched; \"release\" allows motion again";
    }

    /**
     * Returns where the STOP comes from that is latched.
     *
     * @return empty if it was pressed in this program, or no STOP is latched
     */
    public Optional<StopOrigin> stopOrigin() {
        return Optional.ofNullable(stopOrigin);
    }

    /**
     * Returns the signal to wait at for commands to end, robots to become idle or owners to give them back.
     *
     * @return the signal, on this team's clock
     */
    public Signal changes() {
        return changes;
    }

    /**
     * Returns the clock of scripts.
     *
     * @return the clock passed to the constructor
     */
    public TimeSource time() {
        return time;
    }

    /**
     * Sends a message about the team as a whole to its listeners.
     *
     * @param words one sentence
     */
    public void notice(String words) {
        events.publish(listener -> listener.noticed(0, words));
    }

    /**
     * Adds a listener.
     *
     * @param listener called on worker threads
     */
    public void addListener(TeamListener listener) {
        events.add(listener);
    }

    /**
     * Removes a listener.
     *
     * @param listener the listener to remove
     */
    public void removeListener(TeamListener listener) {
        events.remove(listener);
    }

    /**
     * Adds a listener to the beginning of commands.
     *
     * @param listener called on the workers of the robots
     */
    public void addCommandListener(CommandListener listener) {
        events.commandListeners().add(listener);
    }

    /**
     * Removes a listener to the beginning of commands.
     *
     * @param listener the listener to remove
     */
    public void removeCommandListener(CommandListener listener) {
        events.commandListeners().remove(listener);
    }

    /** Stops and closes all robots in parallel; takes at most 3 s, whatever the state of the connections. */
    @Override
    public void close() {
        latched = true;
        List<Member> all = members();
        List<Leases.Stopped> stopped =
                all.stream().map(member -> member.beginStop(null)).toList();
        roster.clear();
        AtomicInteger open = new AtomicInteger(all.size());
        for (Member member : all) {
            member.time().runAsync("closing robot " + member.number(), () -> {
                try {
                    member.close();
                } finally {
                    open.decrementAndGet();
                    changes.raise();
                }
            });
        }
        notifyAfterStop(stopped, () -> {});
        try {
            changes.await(() -> open.get() == 0, CLOSE_BOUND_S);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
