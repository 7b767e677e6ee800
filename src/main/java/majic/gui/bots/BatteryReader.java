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

/** Reads the robots' batteries from time to time, on a thread of its own, because a robot may have to be waited for. */
final class BatteryReader implements AutoCloseable {
    private static final Logger LOG = LateLogger.of(BatteryReader.class);
    private static final int PERIOD_S = 5;

    private final Team team;
    private final Map<Member, BatteryLevel> levels = new ConcurrentHashMap<>();
    private @Nullable ScheduledExecutorService clock;

    BatteryReader(Team team) {
        this.team = team;
    }

    private static Thread thread(Runnable body) {
        Thread thread = new Thread(body, "batteries");
        thread.setDaemon(true);
        return thread;
    }

    /** Begins to read; can be started again after {@link #close()}. */
    void start() {
        close();
        clock = Executors.newSingleThreadScheduledExecutor(BatteryReader::thread);
        clock.scheduleWithFixedDelay(this::readAll, 1, PERIOD_S, TimeUnit.SECONDS);
    }

    /** Returns what was read last. */
    BatteryLevel level(Member member) {
        return levels.getOrDefault(member, BatteryLevel.UNKNOWN);
    }

    private void readAll() {
        levels.keySet().retainAll(team.members());
        team.members().stream().filter(member -> member.bot().isConnected()).forEach(this::read);
    }

    private void read(Member member) {
        try {
            levels.put(member, BatteryLevel.read(member.bot()));
        } catch (RuntimeException | Error e) {
            LOG.log(Level.DEBUG, "the battery of robot " + member.number() + " could not be read", e);
        }
    }

    @Override
    public void close() {
        if (clock != null) {
            clock.shutdownNow();
        }
    }
}
