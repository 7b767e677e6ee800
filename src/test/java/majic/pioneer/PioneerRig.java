package majic.pioneer;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import majic.bot.BotAddress;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import org.jspecify.annotations.Nullable;

/** The driver and a scripted robot on one stepped clock, for one test. */
public final class PioneerRig implements AutoCloseable {
    final ScriptedPioneer robot;
    public final SteppedPeer line;
    public final MajicPioneer bot;
    final List<String> notices = new CopyOnWriteArrayList<>();

    PioneerRig(ScriptedPioneer robot) {
        this(robot, robot, 0);
    }

    PioneerRig(ScriptedPioneer robot, int latencyMs) {
        this(robot, robot, latencyMs);
    }

    /** With an option behind the address. */
    PioneerRig(ScriptedPioneer robot, String option) {
        this(robot, robot, 0, option);
    }

    /** With another peer than the robot itself. */
    PioneerRig(ScriptedPioneer robot, SteppedPeer.Robot peer, int latencyMs) {
        this(robot, peer, latencyMs, "");
    }

    private PioneerRig(ScriptedPioneer robot, SteppedPeer.Robot peer, int latencyMs, String option) {
        this.robot = robot;
        this.line = new SteppedPeer(peer, latencyMs);
        this.bot = new MajicPioneer(
                new BotAddress("pioneer", line.address() + option),
                new BotEnvironment(line.time(), Settings.inMemory()));
        bot.addListener(new BotListener() {
            @Override
            public void notice(MajicBot from, String message) {
                notices.add(message);
            }
        });
    }

    public static PioneerRig connected(ScriptedPioneer robot) {
        return connected(robot, 0);
    }

    static PioneerRig connected(ScriptedPioneer robot, int latencyMs) {
        PioneerRig stage = new PioneerRig(robot, latencyMs);
        stage.bot.connect();
        stage.line.pass(0.01);
        return stage;
    }

    /** Runs an action once, at the first state with the robot beyond a point. */
    public void whenBeyond(double mm, Runnable event) {
        bot.addListener(new BotListener() {
            @Override
            public void stateChanged(MajicBot moving, BotState state) {
                if (Math.abs(state.pose().xMm()) > mm) {
                    moving.removeListener(this);
                    event.run();
                }
            }
        });
    }

    /** Runs an action on another thread to its end; returns what it throws, or null. */
    @Nullable
    Throwable meanwhile(Consumer<MajicPioneer> deed, Runnable here) {
        AtomicReference<Throwable> thrown = new AtomicReference<>();
        AtomicReference<Boolean> over = new AtomicReference<>(false);
        line.time()
                .thread("deed", () -> {
                    try {
                        deed.accept(bot);
                    } catch (RuntimeException e) {
                        thrown.set(e);
                    } finally {
                        over.set(true);
                        line.raise();
                    }
                })
                .start();
        here.run();
        if (!line.await(over::get, 600)) {
            throw new AssertionError("the deed does not end");
        }
        return thrown.get();
    }

    public double secondsOf(Runnable deed) {
        long before = line.time().nanos();
        deed.run();
        return line.time().secondsSince(before);
    }

    public static double amount(MotionReport report) {
        return report.amount() == null ? Double.NaN : report.amount().number();
    }

    @Override
    public void close() {
        bot.close();
        line.close();
    }
}
