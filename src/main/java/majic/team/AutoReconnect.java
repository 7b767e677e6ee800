package majic.team;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.MajicBot.Connection;
import majic.text.LateLogger;
import majic.time.Signal;
import majic.time.TimeSource;

/**
 * Connects robots again whose connection was lost: after 1, 2, 5, 10, 20 and 30 s, then every 30 s, until the robot is
 * connected, removed or cancelled. Another adapter under the name of its serial port is not connected, and reported
 * once. It does what {@link majic.bot.MajicBot#connect()} does and nothing else: no motion, queue, act or manual
 * control resumes, and a latched STOP stays latched. Thread-safe.
 */
public final class AutoReconnect implements TeamListener, AutoCloseable {
    private static final System.Logger LOG = LateLogger.of(AutoReconnect.class);
    private static final int[] DELAYS_S = {1, 2, 5, 10, 20, 30};

    /** A connection that lasts shorter than this continues the delays instead of beginning them again. */
    private static final double STABLE_S = 30;

    private final Team team;
    private final Consumer<Member> changed;
    private final Map<Member, Attempts> attempts = new ConcurrentHashMap<>();
    private volatile boolean enabled;

    /**
     * The state of the attempts for one robot. Immutable.
     *
     * @param connecting whether an attempt is running
     * @param seconds time until the next attempt, 1 to 30; 0 while one is running
     */
    public record Status(boolean connecting, int seconds) {}

    /**
     * Creates it switched off; {@link #enable} switches it on.
     *
     * @param team the robots
     * @param changed receives a robot whose {@link #status} has changed; called on a thread of the robot, must not
     *     block
     */
    public AutoReconnect(Team team, Consumer<Member> changed) {
        this.team = team;
        this.changed = changed;
        team.addListener(this);
    }

    /**
     * Switches the attempts on or off.
     *
     * @param on true also begins attempts for robots that are lost now; false cancels all
     */
    public void enable(boolean on) {
        enabled = on;
        if (on) {
            team.members().stream()
                    .filter(member -> !attempts.containsKey(member))
                    .forEach(this::begin);
        } else {
            attempts.values().forEach(Attempts::cancel);
        }
    }

    /**
     * Returns whether lost robots are connected again.
     *
     * @return true after {@code enable(true)}
     */
    public boolean isEnabled() {
        return enabled;
    }

    /**
     * Returns the state of the attempts for a robot.
     *
     * @param member the robot
     * @return empty while there is nothing to try
     */
    public Optional<Status> status(Member member) {
        return Optional.ofNullable(attempts.get(member)).flatMap(Attempts::status);
    }

    /**
     * Cancels the attempts for a robot until its connection is lost again. An attempt that is running continues.
     *
     * @param member the robot
     */
    public void cancel(Member member) {
        Optional.ofNullable(attempts.get(member)).ifPresent(Attempts::cancel);
    }

    @Override
    public void lost(Member member, String reason) {
        if (enabled) {
            begin(member);
        }
    }

    @Override
    public void removed(Member member) {
        cancel(member);
        attempts.remove(member);
    }

    /** Cancels all attempts and removes the listener. */
    @Override
    public void close() {
        team.removeListener(this);
        enable(false);
    }

    /** A robot that a user is connecting already counts as lost: that may fail. */
    private void begin(Member member) {
        Connection now = member.bot().connection();
        if (now == Connection.LOST || now == Connection.CONNECTING) {
            attempts.compute(member, (same, before) -> {
                        int step = before == null ? 0 : before.replaced();
                        return new Attempts(member, step);
                    })
                    .start();
        }
    }

    /** The attempts after one loss of a connection. */
    private final class Attempts {
        private final Member member;
        private final TimeSource time;
        private final Signal wake;
        private volatile int step;
        private volatile boolean cancelled;
        private volatile Optional<Status> status = Optional.empty();
        private volatile long endedNanos;
        private boolean reported;

        Attempts(Member member, int step) {
            this.member = member;
            this.time = member.time();
            this.wake = time.signal();
            this.step = step;
            this.endedNanos = time.nanos();
        }

        void start() {
            time.tryRunAsync("connecting robot " + member.number() + " again", this::run);
        }

        Optional<Status> status() {
            return cancelled ? Optional.empty() : status;
        }

        void cancel() {
            cancelled = true;
            wake.raise();
        }

        /** Cancels these attempts in favour of those for the next loss; returns the step with which they begin. */
        int replaced() {
            boolean stable = status.isEmpty() && time.secondsSince(endedNanos) >= STABLE_S;
            cancel();
            return stable ? 0 : step;
        }

        private void run() {
            try {
                while (awaitNext()) {
                    connect();
                }
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            } finally {
                endedNanos = time.nanos();
                show(Optional.empty());
            }
        }

        /** Counts down; returns false as soon as there is nothing to try any more. */
        private boolean awaitNext() throws InterruptedException {
            int delay = DELAYS_S[Math.min(step, DELAYS_S.length - 1)];
            for (int left = delay; left > 0 && !isOver(); left--) {
                show(Optional.of(new Status(false, left)));
                wake.await(this::isOver, 1);
            }
            return !isOver();
        }

        /** A connection that is being made at the moment, by a user for instance, may still fail. */
        private boolean isOver() {
            Connection now = member.bot().connection();
            return cancelled || now == Connection.CONNECTED || now == Connection.CLOSED;
        }

        private void connect() {
            step++;
            show(Optional.of(new Status(true, 0)));
            try {
                member.bot().connect();
            } catch (BotException e) {
                reportOtherAdapter(e);
                LOG.log(System.Logger.Level.DEBUG, "robot " + member.number() + " is not connected again yet", e);
            }
        }

        /** Another adapter under the robot's name needs a decision of the user, so that is said, once. */
        private void reportOtherAdapter(BotException failure) {
            boolean isOther = failure instanceof ConnectFailed failed && failed.reason() == Reason.OTHER_ADAPTER;
            if (isOther && !reported) {
                reported = true;
                member.report(new BotException("not connected again: " + failure.getMessage(), failure));
            }
        }

        private void show(Optional<Status> next) {
            status = next;
            changed.accept(member);
        }
    }
}
