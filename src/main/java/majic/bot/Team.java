package majic.bot;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Collection;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * The robots by number, and the STOP that reaches them all. Whoever commands robots, a window, a console, a test, does
 * it through here. Thread-safe.
 */
public final class Team implements AutoCloseable {
    /** How many robots there may be unless set otherwise. */
    public static final int MAX_BOTS = 20;

    /** How long {@link #close()} waits for all robots, seconds. */
    private static final double CLOSE_BOUND_S = 2.5;

    static final Logger LOG = System.getLogger(Team.class.getName());

    private final TimeSource time;
    private final Signal changes;
    private final Roster roster;
    private final List<TeamListener> listeners = new CopyOnWriteArrayList<>();
    private volatile boolean latched;

    /**
     * An empty team of at most {@link #MAX_BOTS} robots.
     *
     * @param time the clock of scripts and of waits for robots: the lab's, if there is one
     */
    public Team(TimeSource time) {
        this(time, MAX_BOTS);
    }

    /**
     * An empty team.
     *
     * @param time the clock of scripts and of waits for robots
     * @param maxBots how many robots there may be, at least 1
     */
    public Team(TimeSource time, int maxBots) {
        this.time = time;
        this.changes = time.signal();
        this.roster = new Roster(maxBots);
    }

    /**
     * Takes in a robot.
     *
     * @param bot a connected one
     * @param wanted its number; empty for the lowest that was never used
     * @return the new member
     * @throws BotException if the number is taken or out of range, or the team is full; the robot was not taken in
     */
    public Member add(MajicBot bot, OptionalInt wanted) {
        Member member = roster.add(wanted, number -> place(number, bot));
        bot.addListener(new MemberNews(this, member));
        member.start();
        tell(listener -> listener.added(member));
        return member;
    }

    /** Either STOP sees the new robot among the others, or this sees that STOP is latched. */
    private Member place(int number, MajicBot bot) {
        Member member = new Member(this, number, bot);
        bot.join(member, "robot " + number + " (" + bot.type().label() + ")");
        if (latched) {
            bot.latch();
        }
        return member;
    }

    /**
     * Checks whether a robot could be taken in, before the trouble of connecting to it.
     *
     * @param wanted its number; empty for the lowest that was never used
     * @throws BotException what {@link #add} would throw now
     */
    public void checkRoom(OptionalInt wanted) {
        roster.number(wanted);
    }

    /**
     * Stops a robot, ends whatever runs on it, closes it and lets it go. Blocks for about a second at most.
     *
     * @param number its number
     * @throws BotException if there is no such robot
     */
    public void remove(int number) {
        Member member = member(number);
        member.stopBegins(null);
        boolean ours = roster.remove(member);
        member.close();
        member.stopEnded();
        if (ours) {
            tell(listener -> listener.removed(member));
        }
    }

    /**
     * A robot by its number.
     *
     * @param number its number
     * @return the member
     * @throws BotException if there is none; the message lists those there are
     */
    public Member member(int number) {
        return roster.member(number);
    }

    /**
     * All robots.
     *
     * @return a snapshot, by number
     */
    public List<Member> members() {
        return roster.all();
    }

    /**
     * Who is here, in words.
     *
     * @return for instance {@code robots: 1 Aibo, 2 Pioneer}
     */
    public String roll() {
        return roll(members());
    }

    /**
     * Who some robots are, in words.
     *
     * @param all the robots
     * @return as {@link #roll()} for the whole team
     */
    public static String roll(List<Member> all) {
        return Roster.words(all);
    }

    /**
     * Stops some robots: ends their motions, empties their queues, ends the acts and scripts that own them. Returns at
     * once; later orders wait until the robot has stopped. Each robot confirms by an answer.
     *
     * @param chosen which robots
     * @param by the script that says so, which is not ended by it; null for a person
     */
    public void stop(Collection<Member> chosen, @Nullable Owner by) {
        if (by == null) {
            tell(listener -> listener.stopped(chosen));
        }
        chosen.forEach(member -> member.stopBegins(by));
        chosen.forEach(member -> sendStop(member, member::stopEnded));
    }

    /** STOP: as {@link #stop} for all robots, and no motion is accepted until {@link #release()}. Returns at once. */
    public void stopAll() {
        latched = true;
        List<Member> all = members();
        all.forEach(Member::holdWork);
        all.forEach(member -> member.stopBegins(null));
        all.forEach(member -> sendStop(member, member::stopEnded));
        tell(listener -> listener.latchChanged(true));
        all.forEach(Member::stopEnded);
    }

    /** Allows motion again after STOP. Nothing resumes by itself. */
    public void release() {
        latched = false;
        members().forEach(Member::release);
        tell(listener -> listener.latchChanged(false));
    }

    /**
     * Whether STOP is latched.
     *
     * @return true from {@link #stopAll()} to {@link #release()}
     */
    public boolean isLatched() {
        return latched;
    }

    void checkLatch() {
        if (latched) {
            throw new BotException("STOP is latched; \"release\" allows motion again");
        }
    }

    /**
     * Where everybody waits who waits for orders to end, robots to become idle or owners to leave.
     *
     * @return the signal, on this team's clock
     */
    public Signal changes() {
        return changes;
    }

    /**
     * The clock of scripts.
     *
     * @return the clock given at the beginning
     */
    public TimeSource time() {
        return time;
    }

    /**
     * Begins to tell somebody of this team.
     *
     * @param listener called on worker threads
     */
    public void addListener(TeamListener listener) {
        listeners.add(listener);
    }

    /**
     * Ends telling somebody.
     *
     * @param listener who was added
     */
    public void removeListener(TeamListener listener) {
        listeners.remove(listener);
    }

    /** Stops and closes all robots side by side; takes at most 3 s, whatever the links do. */
    @Override
    public void close() {
        latched = true;
        List<Member> all = members();
        all.forEach(member -> member.stopBegins(null));
        roster.clear();
        AtomicInteger open = new AtomicInteger(all.size());
        for (Member member : all) {
            Runnable close = () -> {
                try {
                    member.close();
                } finally {
                    open.decrementAndGet();
                    changes.raise();
                }
            };
            member.bot()
                    .time()
                    .thread("closing robot " + member.number(), close)
                    .start();
        }
        try {
            changes.await(() -> open.get() == 0, CLOSE_BOUND_S);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    void answer(Answer answer) {
        tell(listener -> listener.answered(answer));
    }

    void tell(Consumer<TeamListener> news) {
        for (TeamListener listener : listeners) {
            try {
                news.accept(listener);
            } catch (RuntimeException | Error e) {
                LOG.log(Level.WARNING, "a listener of the team failed", e);
            }
        }
    }

    /** On a thread of its own for each link, so that a stuck one holds up nobody. */
    private void sendStop(Member member, Runnable whenSent) {
        Runnable send = () -> {
            String stop = member.number() + " stop: ";
            try {
                member.bot().sendStop();
                answer(new Answer(member.number(), Answer.Outcome.DONE, stop + "done"));
            } catch (RuntimeException | Error e) {
                answer(new Answer(member.number(), Answer.Outcome.FAILED, stop + "failed: " + e.getMessage()));
            } finally {
                whenSent.run();
            }
        };
        member.bot().time().aside("stopping robot " + member.number(), send);
    }
}
