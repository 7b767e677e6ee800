package majic.gui.bots;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import majic.team.Member;
import majic.team.Team;
import majic.text.LateLogger;
import org.jspecify.annotations.Nullable;

/**
 * Reads what the tabs show of the robots' parameters, on a thread of its own, because a robot may have to be waited
 * for.
 */
final class SummaryReader implements AutoCloseable {
    private static final Logger LOG = LateLogger.of(SummaryReader.class);
    private static final int PERIOD_S = 1;

    private final Team team;
    private final Map<Member, SummaryReadings> readings = new ConcurrentHashMap<>();
    private @Nullable ScheduledExecutorService clock;

    SummaryReader(Team team) {
        this.team = team;
    }

    private static Thread thread(Runnable body) {
        Thread thread = new Thread(body, "robot readings");
        thread.setDaemon(true);
        return thread;
    }

    /** Begins to read; can be started again after {@link #close()}. */
    void start() {
        close();
        clock = Executors.newSingleThreadScheduledExecutor(SummaryReader::thread);
        clock.scheduleWithFixedDelay(this::readAll, 1, PERIOD_S, TimeUnit.SECONDS);
    }

    /** Returns what was read last. */
    SummaryReadings readings(Member member) {
        return readings.getOrDefault(member, SummaryReadings.NONE);
    }

    private void readAll() {
        readings.keySet().retainAll(team.members());
        team.members().stream().filter(member -> member.bot().isConnected()).forEach(this::read);
    }

    private void read(Member member) {
        try {
            readings.put(member, SummaryReadings.of(member.bot()));
        } catch (RuntimeException | Error e) {
            LOG.log(Level.DEBUG, "the parameters of robot " + member.number() + " could not be read", e);
        }
    }

    @Override
    public void close() {
        if (clock != null) {
            clock.shutdownNow();
        }
    }
}
