package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import majic.act.NoActs;
import majic.bot.BotType;
import majic.environment.Settings;
import majic.gui.ToyBot;
import majic.gui.ToyType;
import majic.log.SessionLog;
import majic.script.Session;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests the robots that are added at the start. */
class FirstRobotsTest {
    @AutoClose
    private final Team team = new Team(TimeSource.system());

    private final ToyType toys = new ToyType(BotType.Reach.TCP);
    private final Session session = new Session(
            team, new BotFactory(List.of(toys), Settings.inMemory()), SessionLog.none(), NoActs.here(), () -> {});

    private CompletableFuture<Boolean> adding(String... requested) {
        return adding(new FirstRobots(List.of(), List.of(requested)));
    }

    private CompletableFuture<Boolean> adding(FirstRobots robots) {
        return CompletableFuture.supplyAsync(() -> {
            try {
                return robots.addTo(session);
            } catch (InterruptedException e) {
                throw new CompletionException(e);
            }
        });
    }

    private List<Integer> numbers() {
        return team.members().stream().map(Member::number).toList();
    }

    private void awaitTeam(BooleanSupplier condition) throws InterruptedException {
        team.changes().await(condition, WaitLimit.SECONDS);
    }

    @Test
    void aRobotThatDoesNotAnswerDelaysNoOtherAndTheNumbersHaveTheOrderOfTheRequests() throws Exception {
        CompletableFuture<Boolean> adding = adding("add toy:silent", "add toy:one", "add toy:two", "add toy:three");
        awaitTeam(() -> numbers().equals(List.of(2, 3, 4)));

        assertThat(numbers()).containsExactly(2, 3, 4);
        assertThat(adding).isNotDone();
        toys.made.stream().filter(bot -> !bot.isConnected()).forEach(ToyBot::close);
        assertThat(adding.get()).isFalse();
    }

    @Test
    void aRobotOfTheLabThatDoesNotAnswerDelaysNoOtherOfTheLab() throws Exception {
        CompletableFuture<Boolean> adding = adding(new FirstRobots(
                List.of("add toy:silent as 1", "add toy:one as 2", "add toy:two as 3"), List.of("add toy:three")));
        awaitTeam(() -> numbers().equals(List.of(2, 3)));

        assertThat(numbers()).containsExactly(2, 3);
        assertThat(adding).isNotDone();
        toys.made.stream().filter(bot -> !bot.isConnected()).forEach(ToyBot::close);
        assertThat(adding.get()).isFalse();
        assertThat(numbers()).containsExactly(1, 2, 3);
    }

    @Test
    void theSameAddressTwiceIsOneRobot() throws Exception {
        assertThat(adding("add toy:one", "add toy:two", "add toy:one").get()).isFalse();

        assertThat(numbers()).containsExactly(1, 2);
    }

    @Test
    void asManyAsAUsualTeamHasConnectAtOnce() throws Exception {
        String[] requested = IntStream.rangeClosed(1, Team.MAX_BOTS)
                .mapToObj(number -> "add toy:" + (number < Team.MAX_BOTS ? "silent " + number : "last"))
                .toArray(String[]::new);
        CompletableFuture<Boolean> adding = adding(requested);
        awaitTeam(() -> numbers().equals(List.of(Team.MAX_BOTS)));

        assertThat(numbers()).containsExactly(Team.MAX_BOTS);
        toys.made.stream().filter(bot -> !bot.isConnected()).forEach(ToyBot::close);
        assertThat(adding.get()).isFalse();
    }
}
