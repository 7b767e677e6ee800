package majic.act;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.FakeBot;
import majic.bot.Pose;
import majic.nav.CurrentMap;
import majic.nav.file.MapFiles;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majic.team.Member;
import majic.team.Owner;
import majic.team.QueuedCommand;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that an act has exclusive use of its robots. */
@Tag("jdk")
class ActRunTest {
    @TempDir
    private Path folder;

    @AutoClose
    private final TwoRobots rig = new TwoRobots();

    @Test
    void nobodyElseMovesItsRobotsMeanwhile() throws InterruptedException {
        rig.submit(rig.pair());
        rig.time.sleep(1);
        QueuedCommand move = new QueuedCommand("move 1", true, robot -> List.of());
        assertThatThrownBy(() -> rig.second.submit(move, null))
                .hasMessageContaining("2 is running Pair; \"2 stop\" ends it");
        assertThat(rig.said).contains("1: Pair: off we go");
    }

    /** Moves all followers away. */
    private static final class Scatter extends MajicAct {
        private static final long serialVersionUID = 1;

        @Override
        public List<Role> roles() {
            return List.of(Role.any(Role.ME), Role.any("follower").orMore());
        }

        @Override
        protected void behave() {
            robots("follower").forEach(robot -> robot.move(300));
        }
    }

    @Test
    void severalRobotsPlayARoleThatTakesMore() throws InterruptedException {
        FakeBot last = FakeBot.on(rig.time);
        last.connect();
        Member third = rig.team.add(last, OptionalInt.empty());
        Map<String, List<Member>> cast = new LinkedHashMap<>();
        cast.put(Role.ME, List.of(rig.first));
        cast.put("follower", List.of(rig.second, third));
        rig.submit(new ActRun(new Scatter(), "Scatter", cast, rig.first.currentPermit()));
        rig.awaitIdle();
        assertThat(List.of(rig.follower, last))
                .allSatisfy(robot -> assertThat(robot.sent()).startsWith("move 300"));
        assertThat(rig.said).contains("1 act: done");
    }

    /** Shows readings of its robots. */
    private static final class Watch extends MajicAct {
        private static final long serialVersionUID = 1;
        private final String[] parameters;

        Watch(String... parameters) {
            this.parameters = parameters;
        }

        @Override
        public List<Role> roles() {
            return List.of(Role.any(Role.ME), Role.any("other"));
        }

        @Override
        protected void behave() {
            plot(parameters);
        }
    }

    private ActRun watch(String... parameters) {
        Map<String, List<Member>> cast = new LinkedHashMap<>();
        cast.put(Role.ME, List.of(rig.first));
        cast.put("other", List.of(rig.second));
        return new ActRun(new Watch(parameters), "Watch", cast, rig.first.currentPermit());
    }

    @Test
    void itShowsReadingsOfAllItsRobotsInOnePlot() throws InterruptedException {
        List<String> plots = new CopyOnWriteArrayList<>();
        ActRun run = watch("X", "y");
        run.usePlots((robots, parameters) ->
                plots.add(robots.stream().map(Member::number).toList() + " " + parameters));
        rig.submit(run);
        rig.awaitIdle();
        assertThat(plots).containsExactly("[1, 2] [x, y]");
        assertThat(rig.said).contains("1 act: done");
    }

    @Test
    void aPlotThatCannotBeShownFailsTheActWithItsReason() throws InterruptedException {
        rig.submit(watch("x"));
        rig.awaitIdle();
        assertThat(rig.said).anyMatch(line -> line.contains("a plot needs the window of MAJIC, which is not open"));
        ActRun wrong = watch("nonsense");
        wrong.usePlots((robots, parameters) -> {});
        rig.submit(wrong);
        rig.awaitIdle();
        assertThat(rig.said)
                .anyMatch(line -> line.contains(
                        "nonsense: no robot of the act has a number or switch of this name that can be read"));
    }

    /** Says what it knows of the map. */
    private static final class Looks extends MajicAct {
        private static final long serialVersionUID = 1;

        @Override
        protected void behave() {
            say("free " + free(0, 0) + " " + free(1800, 0) + " " + free(9000, 0));
            say("obstacle " + Math.round(distanceToObstacle()));
        }
    }

    private ActRun looking() {
        return new ActRun(new Looks(), "Looks", Map.of(Role.ME, List.of(rig.first)), rig.first.currentPermit());
    }

    private CurrentMap map(OccupancyGrid grid) throws IOException {
        Path file = folder.resolve("map.yaml");
        MapFiles.write(file, NavigationMap.of(grid));
        CurrentMap map = new CurrentMap((robot, news) -> {});
        map.open(file);
        return map;
    }

    @Test
    void itAsksTheMapOfTheTeam() throws InterruptedException, IOException {
        OccupancyGrid wallAhead =
                OccupancyGrid.of(new Pose(-2000, -2000, 0), 100, 40, 40, (column, row) -> column == 39 ? 0.9 : 0.1);
        rig.first.bot().place(Pose.START);
        ActRun run = looking();
        run.useMap(map(wallAhead));
        rig.submit(run);
        rig.awaitIdle();

        assertThat(rig.said).contains("1: Looks: free true false false", "1: Looks: obstacle 1900");
    }

    @Test
    void withoutAMapOrAPlaceOnItItFailsWithWhatWouldBeRight() throws InterruptedException, IOException {
        rig.submit(looking());
        rig.awaitIdle();
        assertThat(rig.said).anyMatch(line -> line.contains("the team has no map; \"map start 2\" builds one"));

        ActRun lost = looking();
        lost.useMap(map(OccupancyGrid.of(Pose.START, 100, 9, 9, (column, row) -> 0.1)));
        rig.submit(lost);
        rig.awaitIdle();
        assertThat(rig.said)
                .anyMatch(line -> line.contains("on the map is not known; \"set pose\" or \"localize\" places it"));
    }

    @Test
    void aRobotThatIsBusyIsNotTakenAway() throws InterruptedException {
        rig.second.submit(
                new QueuedCommand(
                        "move 1000", true, robot -> List.of(robot.move(1000).toString())),
                null);
        rig.time.sleep(0.1);
        rig.submit(rig.pair());
        rig.time.sleep(1);
        assertThat(rig.said).contains("1 act: failed: 2 is still busy; \"2 wait\" lets it finish first");
    }

    @Test
    void aRobotThatIsJustBeingStoppedIsNotTaken() throws InterruptedException {
        rig.follower.standAfter(1);
        rig.team.stop(List.of(rig.second), null);
        rig.submit(rig.pair());
        rig.time.sleep(0.5);
        assertThat(rig.said).contains("1 act: failed: 2 is still busy; \"2 wait\" lets it finish first");
    }

    @Test
    void itsOwnStopEndsNoCommandOfAnotherSource() throws InterruptedException {
        Owner script = new Owner(Owner.Kind.SCRIPT, "script", () -> {});
        ActRun run = rig.alone(new MajicAct() {
            private static final long serialVersionUID = 1;

            @Override
            protected void behave() {
                bot.drive(100, 0);
                bot.stop();
                bot.move(50);
            }
        });
        rig.first.claim(script);
        rig.first.submit(
                new QueuedCommand("act", true, robot -> {
                    run.run(script);
                    return List.of("act: done");
                }),
                script);
        rig.first.submit(new QueuedCommand("turn 90", true, robot -> List.of("turn 90: " + robot.turn(90))), script);
        rig.awaitIdle();
        assertThat(rig.said).anyMatch(line -> line.startsWith("1 turn 90: 90 deg"));
        assertThat(rig.leader.sent()).containsSubsequence("drive 100 0", "halt", "move 50", "turn 90");
    }

    @Test
    void itsRobotsStandBeforeAnybodyElseHasThem() throws InterruptedException {
        rig.leader.standAfter(1);
        rig.follower.standAfter(1);
        rig.submit(rig.both(new TwoRobots.Pair() {
            private static final long serialVersionUID = 1;

            @Override
            protected void behave() {
                bot.drive(100, 0);
                interrupt();
            }
        }));
        rig.awaitIdle();
        assertThat(rig.leader.sent()).endsWith("stands");
        assertThat(rig.follower.sent()).endsWith("stands");
    }
}
