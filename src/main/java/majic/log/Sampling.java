package majic.log;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.team.Member;
import majic.time.Signal;
import majic.time.TimeSource;

/** Reads parameters of robots at regular intervals, into the parameter log. Thread-safe. */
public final class Sampling {
    /** Maximum number of series; each uses a thread. */
    private static final int MOST_SERIES = 20;

    private final ParameterLog log;
    private final TimeSource time;
    private final Consumer<String> notices;
    private final long startNanos;
    private final Signal changes;
    private final Map<Member, Set<Series>> running = new ConcurrentHashMap<>();

    /** Some parameters of one robot, read together. Compared by identity: the same parameters may be logged twice. */
    private static final class Series {
        private final List<String> parameters;
        private final double seconds;

        Series(List<String> parameters, double seconds) {
            this.parameters = parameters;
            this.seconds = seconds;
        }
    }

    /**
     * Creates a sampling with nothing to read yet.
     *
     * @param log receives the readings
     * @param time the clock; times of readings count from now on
     * @param notices receives a sentence when a robot can no longer be read; called on any thread
     */
    public Sampling(ParameterLog log, TimeSource time, Consumer<String> notices) {
        this.log = log;
        this.time = time;
        this.notices = notices;
        this.startNanos = time.nanos();
        this.changes = time.signal();
    }

    /**
     * Starts to log some parameters of a robot, in addition to those already logged. Returns at once.
     *
     * @param member which robot
     * @param parameters their names
     * @param seconds time from one reading to the next, more than zero
     * @throws BotException if {@value #MOST_SERIES} of its logs run already
     */
    public void start(Member member, List<String> parameters, double seconds) {
        Series series = new Series(List.copyOf(parameters), seconds);
        Set<Series> all = running.computeIfAbsent(member, key -> ConcurrentHashMap.newKeySet());
        if (all.size() >= MOST_SERIES) {
            throw new BotException(
                    MOST_SERIES + " logs of this robot run already; \"" + member.number() + " log off\" ends them");
        }
        all.add(series);
        time.thread("parameter log of robot " + member.number(), () -> run(member, series))
                .start();
    }

    /**
     * Ends all logging of a robot.
     *
     * @param member which robot
     */
    public void stop(Member member) {
        running.remove(member);
        changes.raise();
    }

    private void run(Member member, Series series) {
        try {
            long dueNanos = time.nanos();
            while (isWanted(member, series)) {
                read(member, series);
                dueNanos = Math.max(dueNanos + (long) (series.seconds * 1e9), time.nanos());
                changes.await(() -> !isWanted(member, series), (dueNanos - time.nanos()) / 1e9);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (BotException e) {
            forget(member, series);
            report(member, e);
        }
    }

    /** Reports why the logging of a robot ended, unless the robot was removed or the program is closing. */
    private void report(Member member, BotException problem) {
        if (member.bot().connection() != MajicBot.Connection.CLOSED) {
            notices.accept(member.number() + ": no longer logged: " + problem.getMessage());
        }
    }

    private boolean isWanted(Member member, Series series) {
        return running.getOrDefault(member, Set.of()).contains(series);
    }

    private void forget(Member member, Series series) {
        Set<Series> all = running.get(member);
        if (all != null) {
            all.remove(series);
        }
    }

    private void read(Member member, Series series) {
        if (!member.bot().isConnected()) {
            throw new BotException("connection lost");
        }
        for (String parameter : series.parameters) {
            log.add(
                    time.secondsSince(startNanos),
                    member.number(),
                    parameter,
                    member.bot().get(parameter));
        }
    }
}
