package majic.shared;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.act.Role;
import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Anna at desk1 flies the copter that Bert has at desk2, over one broker. */
class SharedCopterInLabTest {
    @AutoClose
    private final TwoDesks desks = new TwoDesks(LabRig.exactWithMavlink("copter+ready"), "mavlink");

    private TwoDesks.Desk anna;

    @BeforeEach
    void useTheCopter() throws InterruptedException {
        desks.pass(2);
        anna = desks.user("desk1", "Anna");
    }

    private void flying() throws InterruptedException {
        assertThat(anna.run("1 set fence 5000 500 5000", "1 arm", "1 takeoff 2000"))
                .anyMatch(line -> line.matches("1 takeoff 2000: \\d+ mm above home"));
    }

    @Test
    void itIsArmedFlownAndStopped() throws InterruptedException {
        flying();
        Pose start = desks.truePose();

        assertThat(anna.run("1 move 800")).anyMatch(line -> line.matches("1 move 800: done .*"));
        assertThat(desks.truePose().distanceMm(start)).isCloseTo(800, within(200.0));

        anna.say("1 move 3000");
        desks.pass(2);
        anna.team.stopAll();
        desks.pass(3);
        Pose stopped = desks.truePose();
        desks.pass(3);
        assertThat(desks.truePose().distanceMm(stopped)).isLessThan(150);
        assertThat(desks.pioneer.get("mode")).hasToString("BRAKE");
    }

    @Test
    void itsHeightIsKnownAtTheOtherDeskUntilTheConnectionIsLost() throws InterruptedException {
        flying();
        desks.pass(1);

        assertThat(anna.bot.profile().leavesGround()).isTrue();
        assertThat(anna.bot.heightMm().orElseThrow())
                .isCloseTo(desks.pioneer.heightMm().orElseThrow(), within(100.0));

        anna.connection().drop();
        desks.pass(1);
        assertThat(anna.bot.heightMm()).isEmpty();
    }

    @Test
    void itsPlaceOnTheEarthHasAllItsDigits() throws InterruptedException {
        desks.pass(1);

        assertThat(anna.bot.get("latitude")).isEqualTo(desks.pioneer.get("latitude"));
        assertThat(anna.bot.get("longitude").toString()).matches("149\\.165\\d{3,4} °");
    }

    @Test
    void aPlaceOutsideOfItsFenceIsRefusedByItsDesk() throws InterruptedException {
        flying();

        assertThat(anna.run("1 goto 9000 0"))
                .anyMatch(line -> line.contains("9000 0 is 9 m from home, outside of the fence of 5 m"));
    }

    @Test
    void actsForRobotsOnTheGroundDoNotTakeItAtTheOtherDesk() {
        assertThat(Role.any(Role.ME).unfit(anna.bot)).isPresent();
        assertThat(Role.any(Role.ME).calling("takeoff").unfit(anna.bot)).isEmpty();
    }
}
