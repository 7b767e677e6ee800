package majic.shared;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majic.shared.broker.BrokerMessage;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests {@code goto} of Anna at desk1 with the Pioneer that Bert has at desk2. */
class SharedGotoInLabTest {
    @AutoClose
    private final TwoDesks desks = new TwoDesks(LabRig.exactWithPioneer("p3dx-sh+laser"));

    private TwoDesks.Desk anna;
    private Pose start;

    @BeforeEach
    void useThePioneer() throws InterruptedException {
        anna = desks.user("desk1", "Anna");
        desks.pass(2);
        start = desks.truePose();
    }

    /** Returns where the Pioneer is, by its start. */
    private Pose driven() {
        return desks.truePose().seenFrom(start);
    }

    private List<String> requests() {
        return desks.broker.published("lab/majic/1/desks/desk2/robots/1/request").stream()
                .map(BrokerMessage::text)
                .filter(request -> request.contains("\"do\":\"goto\""))
                .toList();
    }

    /** Lets the robot of desk2 build a map, on which it is placed then. */
    private void map() throws InterruptedException {
        desks.desk2.run("map start 1", "1 turn 360", "wait", "map stop");
        desks.pass(2);
        assertThat(desks.pioneer.uncertainty().isKnown()).isTrue();
    }

    @Test
    void theRobotArrivesByTheOdometryOfADeskWithoutAMap() throws InterruptedException {
        List<String> said = anna.run("1 goto 800 -300 90");

        assertThat(said)
                .last()
                .asString()
                .matches(
                        "1 goto 800 -300 90: done \\((79|80|81).* mm, -(29|30|31).* mm, (8[789]|9[0-3]).* deg; .* s\\)");
        assertThat(driven().distanceMm(new Pose(800, -300, 0))).isLessThan(30);
        assertThat(requests()).hasSize(1);
    }

    @Test
    void theRobotArrivesByTheMapOfItsDesk() throws InterruptedException {
        map();

        assertThat(anna.run("1 goto 600 0")).last().asString().contains("done (");
        assertThat(driven().distanceMm(new Pose(600, 0, 0))).isLessThan(60);
    }

    @Test
    void aPlaceWithoutAWayFailsWithTheReasonOfTheDesk() throws InterruptedException {
        map();

        assertThat(anna.run("1 goto 90000 0")).last().asString().contains("failed: no way to 90000 0: ");
        assertThat(driven().distanceMm(Pose.START)).isLessThan(20);
    }

    @Test
    void aConditionOnTheRobotIsCheckedAtItsDesk() throws InterruptedException {
        List<String> said = anna.run("1 goto 1000 0 until x > 300");

        assertThat(said)
                .last()
                .asString()
                .matches("1 goto 1000 0 until x > 300: done \\([34]\\d\\d mm, .* deg; .* s\\)");
        assertThat(driven().xMm()).isBetween(300.0, 500.0);
        assertThat(requests()).last().asString().contains("\"until\":\"x > 300\"");
    }

    @Test
    void placeConditionAndAnswerAreInTheFrameInWhichTheRobotIsPlacedHere() throws InterruptedException {
        anna.bot.place(new Pose(5000, 2000, 90));

        List<String> said = anna.run("1 goto 5300 2800 180");

        assertThat(said)
                .last()
                .asString()
                .matches(".*done \\((52|53)\\d\\d mm, (27|28)\\d\\d mm, -?1[78].* deg; .* s\\)");
        assertThat(driven().distanceMm(new Pose(800, -300, 0))).isLessThan(30);
        assertThat(Math.abs(driven().headingDeg() - 90)).isLessThan(4);

        anna.run("1 goto 5000 2000 until y < 2500");

        assertThat(anna.bot.state().pose().yMm()).isBetween(2350.0, 2500.0);
        assertThat(requests()).hasSize(2).last().asString().doesNotContain("until");
    }

    @Test
    void stopOfTheDeskThatAsksEndsIt() throws InterruptedException {
        anna.say("1 goto 2000 0");
        desks.pass(3);
        assertThat(desks.movesWithin(0.5)).isPositive();

        anna.run("1 stop");
        desks.pass(1);

        assertThat(desks.movesWithin(2)).isLessThan(1);
        assertThat(driven().xMm()).isBetween(50.0, 1500.0);
        assertThat(anna.said()).anySatisfy(line -> assertThat(line).contains("goto 2000 0: stopped"));
        assertThat(anna.run("1 goto 1600 0")).last().asString().contains("done (");
    }

    @Test
    void aDeskThatIsGoneDrivesTheRobotNoFurther() throws InterruptedException {
        anna.say("1 goto 2000 0");
        desks.pass(3);

        anna.connection().drop();
        desks.pass(2);

        assertThat(desks.movesWithin(2)).isLessThan(1);
    }

    @Test
    void whileAnotherDeskHoldsTheRobotItIsRefused() throws InterruptedException {
        desks.user("desk3", "Carl").run("1 hold");

        assertThat(anna.run("1 goto 800 0")).last().asString().contains("Carl at desk3");
        assertThat(driven().distanceMm(Pose.START)).isLessThan(1);
    }
}
