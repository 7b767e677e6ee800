package majic.script;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import majic.act.NoActs;
import majic.act.file.ActCatalog;
import majic.bot.FakeBot;
import majic.bot.FakeType;
import majic.drivertest.TestClock;
import majic.environment.Settings;
import majic.log.Line;
import majic.log.SessionListener;
import majic.log.SessionLog;
import majic.team.BotFactory;
import majic.team.Team;
import majic.time.TimeSource;

/** A session with robots that exist only here, on a stepped clock that the test's thread has joined. */
final class ScriptFixture implements AutoCloseable {
    private final TestClock clock = new TestClock();
    final TimeSource time = clock.time();
    final FakeType aibo = new FakeType("aibo");
    final FakeType pioneer = new FakeType("pioneer");
    final Team team = new Team(time);
    final BotFactory factory = new BotFactory(List.of(aibo, pioneer), Settings.inMemory());
    final AtomicInteger quits = new AtomicInteger();
    final Session session;
    final MajicParser prompt;
    final MajicParser pipe;
    private final List<Line> received = Collections.synchronizedList(new ArrayList<>());
    private final SessionListener listener = received::add;

    ScriptFixture() {
        this(NoActs.here());
    }

    /** With the user's own behaviours. */
    ScriptFixture(ActCatalog acts) {
        session = new Session(team, factory, SessionLog.none(), acts, quits::incrementAndGet);
        prompt = MajicParser.prompt(session);
        pipe = MajicParser.pipe(session);
        factory.useLab(new FakeLab(time));
        session.addListener(listener);
    }

    /** Adds a robot past the script, and returns it. */
    FakeBot add(FakeType type) {
        FakeBot bot = (FakeBot) factory.create("sim:" + type.name());
        bot.connect();
        team.add(bot, OptionalInt.empty());
        return bot;
    }

    /** 1 Aibo, 2 Pioneer. */
    static ScriptFixture withTwo() {
        ScriptFixture fixture = new ScriptFixture();
        fixture.add(fixture.aibo);
        fixture.add(fixture.pioneer);
        return fixture;
    }

    FakeBot bot(int number) {
        return (FakeBot) team.member(number).bot();
    }

    /** Lets time pass. */
    void pause(double seconds) throws InterruptedException {
        time.sleep(seconds);
    }

    /** All lines of the session except the repeated commands. */
    List<String> answers() {
        session.flush();
        synchronized (received) {
            return received.stream()
                    .filter(line -> line.kind() != Line.Kind.COMMAND)
                    .map(Line::text)
                    .toList();
        }
    }

    /** Submits a line to the prompt and returns why it was refused, at once or once its files were read. */
    Optional<String> refusal(String line) throws InterruptedException {
        return refused(line).map(Refusal::message);
    }

    /** Submits a line to the prompt and returns its refusal, at once or once its files were read. */
    Optional<Refusal> refused(String line) throws InterruptedException {
        BlockingQueue<Refusal> later = new LinkedBlockingQueue<>();
        Optional<Refusal> now = prompt.submit(line, later::add);
        prompt.awaitAll();
        return now.or(() -> Optional.ofNullable(later.poll()));
    }

    /** Submits lines to the pipe, waits for its end and returns the answers so far. */
    List<String> runPipe(String... lines) throws InterruptedException {
        for (String line : lines) {
            pipe.parseText(line);
        }
        pipe.awaitAll();
        return answers();
    }

    @Override
    public void close() {
        session.removeListener(listener);
        team.close();
        clock.close();
    }
}
