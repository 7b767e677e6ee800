package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import majic.nav.Destination;
import majic.nav.GiveWay;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Robot 2 is asked to make room for robot 1. */
class TeamGiveWayTest {
    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    private final GiveWay giveWay = new TeamGiveWay(fixture.team, fixture.session.map(), member -> false);
    private final GiveWay.Requests requests = giveWay.begin(fixture.bot(1));
    private final AtomicBoolean searched = new AtomicBoolean();
    private final AtomicBoolean failed = new AtomicBoolean();

    private final Supplier<Optional<Destination>> aside = () -> {
        searched.set(true);
        return Optional.of(new Destination(0, 500));
    };

    private boolean ask() {
        return requests.ask(fixture.bot(2), aside, () -> failed.set(true));
    }

    private void awaitIdle() throws InterruptedException {
        fixture.team.changes().await(() -> fixture.team.member(2).isIdle(), 100);
    }

    @Test
    void itsGotoIsAnsweredLikeATypedOne() throws InterruptedException {
        assertThat(ask()).isTrue();
        fixture.pause(0.5);
        fixture.runPipe("2 stop");

        assertThat(fixture.answers()).contains("2 goto 0 500 (makes room for 1): stopped");
        assertThat(failed).isTrue();
    }

    @Test
    void nothingMovesForARobotThatWasStoppedSinceItsMotionBegan() throws InterruptedException {
        fixture.runPipe("1 stop");
        ask();
        awaitIdle();

        assertThat(failed).isTrue();
        assertThat(fixture.bot(2).sent()).noneMatch(line -> line.startsWith("drive") || line.startsWith("turn"));
    }

    @Test
    void nothingMovesAfterAStopOfAllThatWasReleased() throws InterruptedException {
        fixture.runPipe("stop", "release");
        ask();
        awaitIdle();

        assertThat(failed).isTrue();
        assertThat(fixture.bot(2).sent()).noneMatch(line -> line.startsWith("drive") || line.startsWith("turn"));
    }

    @Test
    void aLatchedStopLetsNoneBeAsked() throws InterruptedException {
        fixture.runPipe("stop");

        assertThat(ask()).isFalse();
        assertThat(searched).isFalse();
    }

    @Test
    void aRobotThatHasACommandIsNotAsked() {
        fixture.prompt.parseText("2 move 1000");

        assertThat(ask()).isFalse();
        assertThat(searched).isFalse();
    }

    @Test
    void aRobotForWhichThereIsNoPlaceIsNotSent() throws InterruptedException {
        assertThat(requests.ask(fixture.bot(2), Optional::empty, () -> failed.set(true)))
                .isFalse();
        assertThat(fixture.team.member(2).isIdle()).isTrue();
    }

    @Test
    void aRobotOfAnotherDeskIsNotAsked() {
        GiveWay others = new TeamGiveWay(fixture.team, fixture.session.map(), member -> true);

        assertThat(others.begin(fixture.bot(1)).ask(fixture.bot(2), aside, () -> failed.set(true)))
                .isFalse();
    }
}
