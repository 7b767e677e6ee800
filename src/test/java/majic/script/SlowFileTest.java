package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import majic.act.SlowActs;
import majic.bot.FakeBot;
import majic.bot.FakeType;
import majic.environment.Settings;
import majic.log.SessionLog;
import majic.team.BotFactory;
import majic.team.Team;
import majic.time.TimeSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A file that a line names and that cannot be read for the time being holds up that line and those behind it, no stop.
 */
class SlowFileTest {
    @TempDir
    private static Path folder;

    private final Team team = new Team(TimeSource.system());
    private final BlockingQueue<String> said = new LinkedBlockingQueue<>();
    private final FakeType type = new FakeType();
    private SlowActs slow;
    private Session session;

    @BeforeEach
    void addARobot() throws IOException {
        slow = SlowActs.in(folder);
        BotFactory factory = new BotFactory(List.of(type), Settings.inMemory());
        session = new Session(team, factory, SessionLog.none(), slow.acts(), () -> {});
        session.addListener(line -> said.add(line.text()));
        FakeBot bot = (FakeBot) factory.create("fake://one");
        bot.connect();
        team.add(bot, OptionalInt.empty());
    }

    @AfterEach
    void close() {
        slow.answer();
        team.close();
    }

    private void awaitLine(String line) throws InterruptedException {
        while (!said.take().equals(line)) {
            continue;
        }
    }

    @Test
    void aTypedStopIsTakenAtOnceAndDropsTheLinesThatWait() throws InterruptedException {
        stopOvertakes(MajicParser.prompt(session));
    }

    @Test
    void aStopFromASocketIsTakenAtOnceAndDropsTheLinesThatWait() throws InterruptedException {
        stopOvertakes(MajicParser.socket(session));
    }

    private void stopOvertakes(MajicParser parser) throws InterruptedException {
        parser.parseText("1 act Slow");
        slow.awaitCheck();
        parser.parseText("1 move 30");
        parser.parseText("1 stop");
        awaitLine("1 stop: done");
        slow.agree();
        awaitLine("1 act Slow: not run: stopped");
        awaitLine("1 move 30: not run: stopped");
    }

    @Test
    void theLinesBehindItWaitInTheirOrder() throws InterruptedException {
        MajicParser pipe = MajicParser.pipe(session);
        pipe.parseLine(1, "1 act Slow");
        slow.awaitCheck();
        pipe.parseLine(2, "1 move 30");
        pipe.parseLine(3, "1 get x");
        assertThat(said).doesNotContain("1 x = 30 mm");
        slow.answer();
        assertThat(pipe.awaitAll()).isFalse();
        assertThat(said)
                .anyMatch(line -> line.startsWith("line 1: Slow: it brings code of its own"))
                .contains("1 x = 30 mm");
    }

    @Test
    void aLaterRefusalIsReportedToTheSourceOfTheLine() throws InterruptedException {
        BlockingQueue<String> refusals = new LinkedBlockingQueue<>();
        MajicParser prompt = MajicParser.prompt(session);
        assertThat(prompt.submit("1 act Slow", refusal -> refusals.add(refusal.message())))
                .isEmpty();
        slow.answer();
        assertThat(refusals.take()).startsWith("Slow: it brings code of its own");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"trust PIPE.act", "trust off PIPE.act", "1 act PIPE.act", "1 act PIPE.majic", "run PIPE.majic"})
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no named pipes in folders")
    void aNamedPipeIsRefusedWithoutBeingOpened(String line) throws Exception {
        makePipe("PIPE.act");
        makePipe("PIPE.majic");
        MajicParser pipe = MajicParser.pipe(session);
        pipe.parseText(line.replace("PIPE", folder.resolve("PIPE").toString()));
        assertThat(pipe.awaitAll()).isFalse();
        assertThat(said)
                .anyMatch(answer -> answer.contains("it is a pipe or a device, not a regular file")
                        || answer.contains("not a file with a script"));
    }

    private static void makePipe(String name) throws IOException, InterruptedException {
        new ProcessBuilder("mkfifo", folder.resolve(name).toString()).start().waitFor();
    }
}
