package majicsim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WorldMotionTest {
    private static final double STEP = 0.004;

    private final World world = new World(Rooms.square(2000));

    @Test
    void aBodyThatDrivesFreelyMovesByItsSetVelocityExactly() {
        Body body = add(Body.disc("disc", 60, new Pose(0, 0, 90)));
        body.velocity(250, 0);
        steps(1000);
        assertThat(body.pose().yMm()).isCloseTo(1000, within(1e-6));
        assertThat(body.speedMmPerSec()).isCloseTo(250, within(1e-6));
        assertThat(body.blocked()).isFalse();
    }

    @Test
    void anArcEndsOnItsCircle() {
        Body body = add(Body.disc("disc", 60, new Pose(0, 0, 0)));
        body.velocity(500 * Math.PI / 4, 45);
        steps(500);
        assertThat(body.pose().xMm()).isCloseTo(500, within(1e-6));
        assertThat(body.pose().yMm()).isCloseTo(500, within(1e-6));
        assertThat(body.pose().headingDeg()).isCloseTo(90, within(1e-6));
    }

    @ParameterizedTest
    @ValueSource(doubles = {STEP, 0.1, 10})
    void aWallStopsABodyHoweverLongTheStepIs(double step) {
        Body body = add(Body.box("box", 200, 300, 150, new Pose(0, 0, 0)));
        body.velocity(900, 0);
        for (double t = 0; t < 5; t += step) {
            world.step(step);
        }
        assertThat(body.pose().xMm()).isCloseTo(1800, within(0.5)).isLessThan(1800);
        assertThat(body.blocked()).isTrue();
        assertThat(body.contact().touching()).isTrue();
        assertThat(body.contact().directionDeg()).isBetween(-90.0, 90.0);
    }

    @Test
    void aBodyAloftMeetsNothingAndIsNotDetected() {
        Body flying = add(Body.disc("flying", 60, new Pose(0, 0, 0)));
        Body other = add(Body.disc("other", 60, new Pose(500, 0, 180)));
        assertThat(flying.slide(new Pose(450, 0, 0))).isFalse();
        assertThat(flying.bumps()).isEqualTo(1);
        assertThat(world.ray(other, 500, 0, 180, 1000).found()).isTrue();
        flying.aloft(true);
        assertThat(flying.slide(new Pose(450, 0, 0))).isTrue();
        assertThat(flying.slide(new Pose(1990, 0, 0))).isTrue();
        assertThat(world.ray(other, 500, 0, 0, 1450).found()).isFalse();
        flying.aloft(false);
        assertThat(world.isFree(flying, flying.pose())).isFalse();
    }

    @Test
    void aBlockedBodyCanBackAwayAndIsFreeAgain() {
        Body body = add(Body.disc("disc", 60, new Pose(1930, 0, 0)));
        body.velocity(300, 0);
        steps(100);
        assertThat(body.contact()).isEqualTo(new Contact(true, 0));
        body.velocity(-300, 0);
        steps(10);
        assertThat(body.blocked()).isFalse();
        assertThat(body.contact()).isEqualTo(Contact.NONE);
    }

    @Test
    void aBodyPressedToAWallCanStillTurnAway() {
        Body body = add(Body.disc("disc", 60, new Pose(1930, 0, 0)));
        body.velocity(300, 90);
        steps(250);
        assertThat(body.blocked()).isTrue();
        assertThat(body.pose().headingDeg()).isCloseTo(90, within(1e-6));
    }

    @Test
    void bothBodiesFeelACollision() {
        Body pusher = add(Body.disc("pusher", 60, new Pose(0, 0, 0)));
        Body stander = add(Body.box("stander", 100, 100, 80, new Pose(300, 0, 90)));
        pusher.velocity(200, 0);
        steps(500);
        assertThat(pusher.pose().xMm()).isCloseTo(160, within(0.5));
        assertThat(pusher.contact().directionDeg()).isCloseTo(0, within(1e-6));
        assertThat(stander.contact().touching()).isTrue();
        assertThat(stander.contact().directionDeg()).isCloseTo(90, within(20.0));
        assertThat(stander.blocked()).isFalse();
    }

    @Test
    void aBodyCannotBePutIntoAWallOrAnotherBody() {
        Body body = add(Body.disc("disc", 60, new Pose(0, 0, 0)));
        add(Body.disc("other", 60, new Pose(500, 0, 0)));
        assertThatThrownBy(() -> body.place(new Pose(1950, 0, 0))).hasMessageContaining("disc does not fit at");
        assertThatThrownBy(() -> body.place(new Pose(450, 0, 0))).isInstanceOf(IllegalArgumentException.class);
        assertThat(body.pose()).isEqualTo(new Pose(0, 0, 0));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void bodiesNeverOverlapAWallOrEachOther(long seed) {
        Random random = new Random(seed);
        World cage = new World(Room.standard());
        List<Body> bodies = List.of(
                Body.box("a", 150, 120, 70, cage.room().home(1)),
                Body.box("b", 210, 301, 200, cage.room().home(2)),
                Body.disc("c", 60, cage.room().home(3)));
        bodies.forEach(cage::add);
        for (int i = 0; i < 5000; i++) {
            if (i % 200 == 0) {
                bodies.forEach(b -> b.velocity(random.nextInt(-2000, 2000), random.nextInt(-200, 200)));
            }
            cage.step(STEP);
            assertThat(bodies).allMatch(b -> cage.isFree(b, b.pose()) && inside(cage.room(), b));
        }
    }

    private static boolean inside(Room room, Body body) {
        return body.outline().stream().allMatch(p -> room.bounds().contains(p.xMm(), p.yMm()));
    }

    private Body add(Body body) {
        world.add(body);
        return body;
    }

    private void steps(int count) {
        for (int i = 0; i < count; i++) {
            world.step(STEP);
        }
    }
}
