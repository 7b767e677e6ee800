package majic.script;

import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import majic.act.NoActs;
import majic.bot.FakeType;
import majic.bot.MajicBot;
import majic.environment.Settings;
import majic.log.SessionLog;
import majic.team.BotFactory;
import majic.team.Team;
import majic.time.TimeSource;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures how long a typed line takes from its text to its queue: parsed, checked, submitted. The command only sets a
 * parameter of a robot that exists only here.
 *
 * <p>Result: {@link #lineWithAnExpression} divided by {@link #plainLine}, and {@link #plainLine} of two versions.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(2)
public class LineBenchmark {
    private Team team;
    private MajicParser parser;

    /** Makes a session with one robot. */
    @Setup
    public void open() {
        FakeType type = new FakeType("aibo");
        team = new Team(TimeSource.system());
        BotFactory factory = new BotFactory(List.of(type), Settings.inMemory());
        MajicBot robot = factory.create("aibo://127.0.0.1");
        robot.connect();
        team.add(robot, OptionalInt.empty());
        Session session = new Session(team, factory, SessionLog.none(), NoActs.here(), () -> {});
        parser = MajicParser.pipe(session);
        parser.parseText("let n = 100");
    }

    /** Measures a line without values. */
    @Benchmark
    public boolean plainLine() throws InterruptedException {
        return done("1 set near 300");
    }

    /** Measures a line with a value that is computed. */
    @Benchmark
    public boolean lineWithAnExpression() throws InterruptedException {
        return done("1 set near ($n * 3)");
    }

    private boolean done(String line) throws InterruptedException {
        boolean accepted = parser.parseText(line).isEmpty();
        parser.awaitAll();
        return accepted;
    }

    /** Closes the robot. */
    @TearDown
    public void close() {
        team.close();
    }
}
