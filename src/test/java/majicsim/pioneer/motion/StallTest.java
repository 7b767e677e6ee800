package majicsim.pioneer.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import majicsim.pioneer.model.PioneerModel;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;

class StallTest {
    private static final int VEL = 11;
    private static final int RVEL = 21;

    /** Its front is 500 mm from the wall. */
    private static Rig facingTheWall(String model) {
        Pose start = new Pose(5000 - 500 - PioneerModel.of(model).frontMm(), 0, 0);
        return new Rig(start, Noise.exact(), model).shakeHands().command(4, 1);
    }

    @Test
    void drivingIntoAWallStallsBothMotorsUntilTheRobotIsDrivenAway() {
        Rig rig = facingTheWall("p3dx-sh").command(VEL, 300).pulse(4);
        for (SipView sip : rig.pulse(1).sips().subList(30, 40)) {
            assertThat(sip.isStalled()).isTrue();
            assertThat(sip.left()).isBetween(-2, 2);
            assertThat(sip.x()).isBetween(499, 501);
        }
        rig.command(VEL, -200).step(0.4);
        rig.nextSip();
        assertThat(rig.nextSip().isStalled()).isFalse();
    }

    @Test
    void theSonarAheadIsAtItsMinimum() {
        Rig rig = facingTheWall("p3dx-sh").command(VEL, 300).pulse(4);
        rig.line.take();
        assertThat(rig.pulse(0.8).sips())
                .anySatisfy(sip -> assertThat(sip.sonar()).containsEntry(3, 100));
    }

    @Test
    void givingUpClearsTheStall() {
        Rig rig = facingTheWall("p3dx-sh").command(VEL, 300).pulse(4);
        assertThat(rig.command(VEL, 0).nextSip().isStalled()).isFalse();
    }

    @Test
    void aStallBetweenTwoSipsIsStillReported() {
        Rig rig = facingTheWall("p3dx-sh").command(VEL, 300);
        while (!rig.body().blocked()) {
            rig.command(0, 0).step(Rig.STEP_SECONDS);
        }
        assertThat(rig.command(VEL, 0).nextSip().isStalled()).isTrue();
        assertThat(rig.nextSip().isStalled()).isFalse();
    }

    @Test
    void itTurnsAwayFromTheWallOnceItBackedOff() {
        Rig rig = facingTheWall("p3dx-sh").command(VEL, 300).pulse(4);
        rig.command(VEL, -300).pulse(2).command(VEL, 0).command(RVEL, 45).pulse(3);
        assertThat(rig.nextSip().turnRateTenths()).isEqualTo(450);
        assertThat(rig.nextSip().isStalled()).isFalse();
    }

    @Test
    void aMoveThatIsStoppedByAWallGoesOnWhenTheWayIsFree() {
        Rig rig = facingTheWall("p3dx-sh").command(8, 1000).pulse(4);
        assertThat(rig.nextSip().isStalled()).isTrue();
        rig.body().place(new Pose(0, 0, 0));
        rig.pulse(5);
        assertThat(rig.pose().xMm()).isCloseTo(500, within(1.0));
    }

    @Test
    void bumpersReportWhereItTouches() {
        Rig rig = facingTheWall("peoplebot-sh").command(VEL, 300).pulse(4);
        assertThat(rig.nextSip().frontBumpers()).isNotZero();
        assertThat(rig.nextSip().rearBumpers()).isZero();
        rig.command(VEL, -300).pulse(2);
        assertThat(rig.nextSip().frontBumpers()).isZero();
    }
}
