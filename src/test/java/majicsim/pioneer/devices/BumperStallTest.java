package majicsim.pioneer.devices;

import static org.assertj.core.api.Assertions.assertThat;

import majicsim.pioneer.PioneerRobot;
import majicsim.pioneer.Rig;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Bumper segments by where something touches, and BUMPSTALL (ARCOS sheet 6.1, 8). */
class BumperStallTest {
    private static final int VEL = 11;
    private static final int BUMPSTALL = 44;
    private static final String PEOPLEBOT = "peoplebot-sh";

    /** Half of the robot's width and of its length, and the radius of what bumps into it. */
    private static final double SIDE_MM = 212.5;

    private static final double END_MM = 256.5;
    private static final double RADIUS_MM = 50;

    private final Rig rig =
            new Rig(new Pose(0, 0, 0), Noise.exact(), PEOPLEBOT).shakeHands().command(4, 1);

    @ParameterizedTest
    @CsvSource({"150, 0b00001", "75, 0b00010", "0, 0b00100", "-75, 0b01000", "-150, 0b10000"})
    void frontSegmentsCountFromLeftToRight(double yMm, String segment) {
        bump(END_MM + RADIUS_MM, yMm, 180);
        assertThat(rig.nextSip().frontBumpers()).isEqualTo(bits(segment));
        assertThat(rig.nextSip().rearBumpers()).isZero();
    }

    @ParameterizedTest
    @CsvSource({"-150, 0b00001", "0, 0b00100", "150, 0b10000"})
    void rearSegmentsGoOnClockwiseFromRightToLeft(double yMm, String segment) {
        bump(-END_MM - RADIUS_MM, yMm, 0);
        assertThat(rig.nextSip().rearBumpers()).isEqualTo(bits(segment));
        assertThat(rig.nextSip().frontBumpers()).isZero();
    }

    @ParameterizedTest
    @CsvSource({"0, 150, false", "1, 150, true", "2, 150, false", "3, 150, true", "3, -150, false", "1, -150, false"})
    void aTouchAtTheFrontStallsForwardMotionWhereThatIsSet(int bumpStall, int speed, boolean stalls) {
        bumpBesideTheFront();
        assertThat(rig.nextSip().frontBumpers()).isEqualTo(1);
        rig.command(BUMPSTALL, bumpStall).command(VEL, speed).pulse(0.4);
        assertThat(rig.nextSip().isStalled()).isEqualTo(stalls);
        assertThat(Math.abs(rig.pose().xMm()) < 1).isEqualTo(stalls);
    }

    @Test
    void onceNothingTouchesAnyMoreItGoesOn() {
        Body other = bumpBesideTheFront();
        assertThat(rig.command(VEL, 150).pulse(1).nextSip().isStalled()).isTrue();
        other.place(new Pose(3000, 3000, 0));
        assertThat(rig.pulse(2).nextSip().isStalled()).isFalse();
        assertThat(rig.nextSip().left()).isEqualTo(150);
    }

    @Test
    void afterAStallTheMotorsRestForTheStallCountBeforeTheyTryAgain() {
        Rig pushing = new Rig(new Pose(4790 - 2, 0, 0), Noise.exact(), PioneerRobot.STANDARD_MODEL)
                .shakeHands()
                .command(4, 1)
                .command(VEL, 300);
        while (!pushing.body().blocked()) {
            pushing.step(Rig.STEP_SECONDS);
        }
        int tries = 0;
        for (int step = 0; step < 250; step++) {
            pushing.step(Rig.STEP_SECONDS);
            tries += pushing.body().blocked() ? 1 : 0;
        }
        assertThat(pushing.config().number("STALLCOUNT")).isEqualTo(200);
        assertThat(tries).isBetween(4, 5);
    }

    @Test
    void anotherModelHasOtherBumpers() {
        assertThat(Rig.open("powerbot-sh").config().numbers())
                .containsEntry("FRONTBUMPS", 7)
                .containsEntry("REARBUMPS", 5);
        assertThat(Rig.open().config().numbers()).containsEntry("FRONTBUMPS", 0);
    }

    /** Touches the leftmost front segment from the side, where it blocks nothing. */
    private Body bumpBesideTheFront() {
        return bump(150, SIDE_MM + RADIUS_MM, -90);
    }

    /** A round thing comes from 5 mm away until it touches. */
    private Body bump(double xMm, double yMm, double headingDeg) {
        Body thing = Body.disc("thing", RADIUS_MM, new Pose(xMm, yMm, headingDeg).driven(-5, 0));
        rig.world.add(thing);
        thing.velocity(100, 0);
        rig.step(0.2);
        thing.velocity(0, 0);
        rig.step(0.02);
        return thing;
    }

    private static int bits(String binary) {
        return Integer.parseInt(binary.substring(2), 2);
    }
}
