package majic.aibo.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majic.aibo.urbi.UrbiValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SkeletonTest {
    private static final BodyPoint NOSE = new BodyPoint(80, 0, 0);

    private final SensorReadings senses = new SensorReadings();

    @ParameterizedTest
    @EnumSource(Limb.class)
    void aStandingDogHasItsPawsNearTheGround(Limb limb) {
        assertThat(skeleton().leg(limb).foot().z()).isBetween(0.0, 35.0);
        assertThat(skeleton().leg(limb).top().z()).isGreaterThan(70);
        assertThat(skeleton().pitchDeg()).isCloseTo(0, within(12.0));
    }

    @Test
    void aSittingDogIsHighInFront() {
        legs(-45, -9, 10, -75, 15, 119);
        put(Sensor.ACCEL_X, -5.6);
        put(Sensor.ACCEL_Y, 0);
        put(Sensor.ACCEL_Z, -8);

        assertThat(skeleton().pitchDeg()).isBetween(30.0, 65.0);
    }

    @Test
    void aLyingDogRestsOnItsBelly() {
        legs(55, -5, 40, -120, 0, 119);

        assertThat(skeleton().body(new BodyPoint(0, 0, 0)).z()).isLessThan(60);
    }

    @Test
    void headPanTurnsTheNoseToTheLeftAndTiltRaisesIt() {
        BodyPoint ahead = skeleton().head(NOSE);
        put(Sensor.HEAD_PAN, 60);
        put(Sensor.HEAD_TILT, 30);

        assertThat(skeleton().head(NOSE).y()).isGreaterThan(ahead.y() + 40);
        assertThat(skeleton().head(NOSE).z()).isGreaterThan(ahead.z() + 20);
    }

    @Test
    void aBowedNeckBringsTheHeadAheadAndDown() {
        BodyPoint upright = skeleton().head(new BodyPoint(0, 0, 0));
        put(Sensor.NECK, -79);
        BodyPoint bowed = skeleton().head(new BodyPoint(0, 0, 0));

        assertThat(bowed.x()).isGreaterThan(upright.x() + 50);
        assertThat(bowed.z()).isLessThan(upright.z() - 40);
    }

    @Test
    void theMouthOpensDownwards() {
        BodyPoint shut = jaw();
        put(Sensor.MOUTH, -58);

        assertThat(jaw().z()).isLessThan(shut.z() - 20);
    }

    @Test
    void theTailRisesAndPointsToTheLeft() {
        BodyPoint low = skeleton().tail(1);
        put(Sensor.TAIL_TILT, 45);
        put(Sensor.TAIL_PAN, 59);

        assertThat(skeleton().tail(1).z()).isGreaterThan(low.z() + 15);
        assertThat(skeleton().tail(1).y()).isGreaterThan(low.y() + 5);
        assertThat(low.x()).isLessThan(skeleton().tail(0).x() - 20);
    }

    @Test
    void aSpreadLegPointsToItsOwnSide() {
        put(Sensor.LEG_LF2, 60);
        put(Sensor.LEG_RF2, 60);

        assertThat(skeleton().leg(Limb.LEFT_FORE).foot().y()).isGreaterThan(120);
        assertThat(skeleton().leg(Limb.RIGHT_FORE).foot().y()).isLessThan(-120);
    }

    @Test
    void aBodyRestsWhereItsMiddleIsBetweenTheTwoItTouches() {
        List<BodyPoint> points =
                List.of(new BodyPoint(-10, 0, -10), new BodyPoint(10, 0, -10), new BodyPoint(30, 0, 0));

        GroundContact level = GroundContact.of(points, 0);

        assertThat(level.pitchDeg()).isCloseTo(0, within(1e-9));
        assertThat(level.onGround(new BodyPoint(0, 0, 0)).z()).isCloseTo(10, within(1e-9));
    }

    private Skeleton skeleton() {
        return new Skeleton(senses);
    }

    private BodyPoint jaw() {
        return skeleton().jaw(new BodyPoint(18, 0, -20), new BodyPoint(40, 0, 0));
    }

    private void legs(double fore1, double fore2, double fore3, double hind1, double hind2, double hind3) {
        for (Joint joint : Joint.named("leg")) {
            boolean fore = joint.urbiName().charAt(4) == 'F';
            double angle = switch (joint.urbiName().charAt(5)) {
                case '1' -> fore ? fore1 : hind1;
                case '2' -> fore ? fore2 : hind2;
                default -> fore ? fore3 : hind3;
            };
            put(joint.sensor(), angle);
        }
    }

    private void put(Sensor sensor, double amount) {
        senses.put(sensor, new UrbiValue.Num(amount), 0);
    }
}
