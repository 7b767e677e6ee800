package majic.shared;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.ScanListener;
import majic.inlab.LabRig;
import majic.nav.grid.OccupancyGrid.State;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests what Anna at desk1 has of the sonars and the laser of the Pioneer that Bert has at desk2. */
class SharedScansInLabTest {
    private static final String SCANS = "lab/majic/1/desks/desk2/robots/1/scans";

    @AutoClose
    private final TwoDesks desks = new TwoDesks(LabRig.exactWithPioneer("p3dx-sh+laser"));

    private final List<RangeScan> scans = new CopyOnWriteArrayList<>();
    private final ScanListener listener = scans::add;
    private TwoDesks.Desk anna;

    @BeforeEach
    void useThePioneer() throws InterruptedException {
        anna = desks.user("desk1", "Anna");
        desks.pass(2);
    }

    private void publish(String scan) {
        desks.ofDesk2.get(0).publish(BrokerMessage.json(SCANS, scan, Quality.AT_MOST_ONCE));
    }

    private int published() {
        return desks.broker.published(SCANS).size();
    }

    private int arrivedWithin(double seconds) throws InterruptedException {
        int before = scans.size();
        desks.pass(seconds);
        return scans.size() - before;
    }

    @Test
    void theRangeSensorsAreThoseAtItsDesk() {
        assertThat(anna.bot.rangeSensors())
                .hasSize(2)
                .usingRecursiveComparison()
                .isEqualTo(desks.pioneer.rangeSensors());
    }

    @Test
    void scansComeWhileSomebodyListensAtMostFiveTimesASecond() throws InterruptedException {
        assertThat(published()).isZero();

        anna.bot.addScanListener(listener);
        desks.pass(1);
        assertThat(arrivedWithin(10)).isBetween(80, 102);
        assertThat(scans).extracting(RangeScan::sensor).hasSameElementsAs(anna.bot.rangeSensors());
        assertThat(scans).allSatisfy(scan -> {
            assertThat(scan.timeS()).isLessThanOrEqualTo(anna.bot.time().nanos() / 1e9);
        });
        RangeScan last = scans.get(scans.size() - 1);
        assertThat(anna.bot.time().nanos() / 1e9 - last.timeS()).isLessThan(1);

        anna.bot.removeScanListener(listener);
        desks.pass(6);
        int before = published();
        desks.pass(2);
        assertThat(published()).isEqualTo(before);
    }

    @Test
    void aDeskThatIsGoneCostsNoScansAfterSomeSeconds() throws InterruptedException {
        anna.bot.addScanListener(listener);
        desks.pass(2);
        assertThat(published()).isPositive();

        anna.connection().drop();
        desks.pass(6);
        int before = published();
        desks.pass(2);
        assertThat(published()).isEqualTo(before);
    }

    @Test
    void damagedScansAreLeftOut() throws InterruptedException {
        anna.bot.addScanListener(listener);
        desks.pass(2);
        for (String damaged : List.of(
                "",
                "{}",
                "[1]",
                "{\"clock\":0,\"age\":0,\"sensor\":\"sonar\",\"odometry\":{\"x\":0,\"y\":0,\"heading\":0},\"ranges\":[7]}",
                "{\"clock\":0,\"age\":0,\"sensor\":\"radar\",\"odometry\":{\"x\":0,\"y\":0,\"heading\":0},\"ranges\":[7]}")) {
            publish(damaged);
        }

        assertThat(arrivedWithin(2)).isBetween(12, 22);
        assertThat(anna.bot.isConnected()).isTrue();
        assertThat(scans).allSatisfy(scan -> assertThat(scan.size()).isGreaterThan(1));
    }

    @Test
    void scansThatWereLongOnTheirWayAreNotDelivered() throws InterruptedException {
        List<Double> agesS = new CopyOnWriteArrayList<>();
        anna.bot.addScanListener(scan -> agesS.add(anna.bot.time().nanos() / 1e9 - scan.timeS()));
        desks.pass(2);
        int before = agesS.size();
        anna.connection().holdBack();
        desks.pass(1.6);
        assertThat(agesS).hasSizeBetween(before, before + 2);
        anna.connection().deliver();
        desks.pass(6);

        assertThat(agesS)
                .hasSizeGreaterThan(before + 10)
                .allSatisfy(age -> assertThat(age).isLessThan(1.1));
    }

    @Test
    void aScanIsAtThePoseOfTheRobotAlsoWhenItsDeskPlacesItElsewhere() throws InterruptedException {
        anna.bot.addScanListener(listener);
        desks.pioneer.place(new Pose(3000, -2000, 90));
        desks.pass(2);
        anna.run("1 move 400");
        desks.pass(1);
        RangeScan last = scans.get(scans.size() - 1);

        assertThat(last.odometry().xMm()).isCloseTo(400, within(20.0));
        Pose at = anna.bot.odometryOrigin().plus(last.odometry());
        assertThat(at.distanceMm(anna.bot.state().pose())).isLessThan(5);
        assertThat(at.distanceMm(desks.pioneer.state().pose())).isLessThan(5);
        assertThat(at.yMm()).isCloseTo(-1600, within(20.0));
    }

    @Test
    void aSharedRobotBuildsAMap() throws InterruptedException {
        anna.run("map start 1", "1 move 400", "wait", "map stop");

        Pose here = anna.bot.state().pose();
        assertThat(anna.session.map().get()).hasValueSatisfying(map -> {
            assertThat(map.grid().stateAt(here.xMm() + 500, here.yMm())).isEqualTo(State.FREE);
            assertThat(map.grid().count(State.OCCUPIED)).isPositive();
        });
    }

    @Test
    void theMapStaysInOnePieceThoughTheDeskPlacesTheRobotElsewhereMeanwhile() throws InterruptedException {
        anna.run("map start 1", "1 move 200");
        Pose before = anna.bot.state().pose();
        desks.pioneer.place(new Pose(9000, 9000, 90));
        desks.pass(2);
        anna.run("1 move 200", "wait", "map stop");

        assertThat(before.distanceMm(new Pose(200, 0, 0))).isLessThan(20);
        assertThat(anna.session.map().get())
                .hasValueSatisfying(map ->
                        assertThat(map.grid().width() * map.grid().cellMm()).isLessThan(14_000));
    }

    @Test
    void aSharedRobotIsNotFollowedOnTheMapOfAnotherDesk() throws InterruptedException {
        anna.run("map start 1", "1 move 200", "wait", "map stop", "1 set pose 200 0 0");
        desks.pass(6);
        int before = published();
        anna.run("1 move 200");

        assertThat(anna.bot.uncertainty().isKnown()).isTrue();
        assertThat(published()).isEqualTo(before);
    }

    @Test
    void localizeSaysThatTheDeskOfTheRobotHasNoMap() throws InterruptedException {
        anna.run("map start 1", "1 move 200", "wait", "map stop");

        assertThat(anna.run("1 localize")).last().asString().contains("at desk2: localize: there is no map");
    }

    @Test
    void localizeLooksForTheRobotAtItsDesk() throws InterruptedException {
        desks.desk2.run("map start 1", "1 move 200", "wait", "map stop");
        desks.pass(2);
        assertThat(anna.bot.uncertainty().isKnown()).isTrue();

        assertThat(anna.run("1 localize")).last().asString().startsWith("1 localize: looks for its place");
        desks.pass(2);

        assertThat(desks.pioneer.uncertainty().isKnown()).isFalse();
        assertThat(anna.bot.uncertainty().isKnown()).isFalse();
        assertThat(anna.run("1 get placed")).last().asString().contains("unknown");
    }
}
