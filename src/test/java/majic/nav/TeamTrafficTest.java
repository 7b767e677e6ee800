package majic.nav;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majic.nav.path.Way;
import majicsim.LabOptions;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Two Pioneers 3 m apart, of which the first has reserved the way to the second. */
class TeamTrafficTest {
    private static final Pose HERE = new Pose(0, 0, 0);
    private static final Pose THERE = new Pose(3000, 0, 180);
    private static final Pose BETWEEN = new Pose(1500, 0, 0);

    @AutoClose
    private final LabRig rig = LabRig.of(LabOptions.exactOnFreePorts().withPioneers(2));

    private final TeamTraffic traffic = new TeamTraffic();
    private final TeamTraffic.Vehicle first = traffic.begin(placed("pioneer", HERE));
    private final TeamTraffic.Vehicle second = traffic.begin(placed("pioneer2", THERE));

    TeamTrafficTest() {
        traffic.reserve(first, Way.through(List.of(HERE, THERE)), 2000);
    }

    private MajicBot placed(String name, Pose place) {
        MajicBot robot = rig.add(name);
        robot.place(place);
        return robot;
    }

    @Test
    void whatOneHasReservedIsNotFreeForTheOther() {
        assertThat(traffic.isFree(second, BETWEEN)).isFalse();
        assertThat(traffic.isFree(second, new Pose(1500, 3000, 0))).isTrue();
        assertThat(traffic.isFree(first, BETWEEN)).isTrue();
    }

    @Test
    void oneThatGivesBackKeepsItsPlaceAndItsWay() {
        traffic.giveBack(first);

        assertThat(traffic.isFree(second, BETWEEN)).isTrue();
        assertThat(traffic.isFree(second, new Pose(500, 0, 0))).isFalse();
        assertThat(traffic.reserved(first.robot())).containsExactly(HERE);
        assertThat(traffic.way(first.robot())).map(Way::end).contains(new Pose(3000, 0, 0));
    }

    @Test
    void oneThatMakesRoomHasNotWaitedYet() throws InterruptedException {
        traffic.noteWait(second, true);
        rig.lab().time().sleep(5);
        assertThat(traffic.noteWait(second, true)).isGreaterThan(4);

        traffic.standIn(second, first);
        assertThat(traffic.noteWait(second, true)).isZero();
    }
}
