package majicsim.hemisson.behaviour;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import java.util.TreeSet;
import majicsim.hemisson.Desk;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Sheet 7: what the switches make of the robot when it starts. */
class RunModeTest {
    private static final String INTERNAL = "D\u00e9marrage en mode Interne␍␊";
    private static final String THIRD_LINES_END = "com␍␊␍␊";

    @ParameterizedTest
    @CsvSource({"1111,false", "1110,true", "1101,true", "1011,true", "0111,false", "0101,true", "0000,true"})
    void allButRemoteControlAndBotStudioGreetWithAFourthLine(String switches, boolean fourth) {
        Desk desk = desk(switches);
        desk.robot.handling().powerCycle();
        assertThat(desk.after(0.04)).endsWith(THIRD_LINES_END + (fourth ? INTERNAL : ""));
    }

    @ParameterizedTest
    @ValueSource(strings = {"1110", "1101", "1011", "0111"})
    void aModeOfItsOwnAnswersDrivingButDrivesAsItLikes(String switches) {
        Desk desk = desk(switches);
        desk.after(0.1);
        assertThat(desk.ask("I")).isEqualTo("i," + String.join(",", switches.split("")));
        assertThat(desk.ask("D,7,-6")).isEqualTo("d");
        desk.after(0.9);
        assertThat(desk.ask("E")).isNotEqualTo("e,07,-6");
    }

    @Test
    void withAnEmptyBotStudioProgramTheSpeedsAreHeldAtZero() {
        Desk desk = desk("0111");
        assertThat(desk.ask("D,5,-5")).isEqualTo("d");
        assertThat(desk.ask("E")).isEqualTo("e,00,00");
    }

    @Test
    void theDanceSwingsAsTheFactoryFirmwareDoes() {
        Desk desk = desk("1011");
        Set<String> seen = new TreeSet<>();
        for (int i = 0; i < 40; i++) {
            desk.after(0.1);
            seen.add(desk.ask("E"));
        }
        assertThat(seen).containsExactly("e,-5,-10", "e,10,05");
    }

    @ParameterizedTest
    @ValueSource(strings = {"0101", "0000", "1100"})
    void anyOtherSettingAnswersTwoCharactersAndIsBlockedByMore(String switches) {
        Desk desk = desk(switches);
        assertThat(desk.ask("I")).startsWith("i,");
        assertThat(desk.ask("E")).isEqualTo("e,00,00");
        assertThat(desk.ask("D,5,5")).isEmpty();
        assertThat(desk.robot.handling().isReceiverBlocked()).isTrue();
        assertThat(desk.ask("I")).isEmpty();
    }

    @Test
    void movedSwitchesAreReadWithin41MillisecondsAndChangeTheModeOnlyAfterAReset() {
        Desk desk = desk("0111");
        desk.robot.handling().moveSwitches(HemissonOptions.REMOTE_CONTROL);
        desk.after(0.044);
        assertThat(desk.ask("I")).isEqualTo("i,1,1,1,1");
        assertThat(desk.ask("D,5,5") + desk.ask("E")).isEqualTo("de,00,00");

        desk.ask("Z");
        desk.after(0.02);

        assertThat(desk.ask("D,5,5") + desk.ask("E")).isEqualTo("de,05,05");
    }

    @Test
    void avoidingItTurnsAwayFromAWallAndDrivesOn() {
        Desk desk = Desk.inTheRoom(HemissonOptions.standard().withSwitches("1110"));
        Pose nearTheWall = new Pose(-4300, -2000, 170);
        desk.robot.body().place(nearTheWall);

        desk.after(20);

        assertThat(desk.robot.body().bumps()).isZero();
        assertThat(desk.robot.body().pose().distanceTo(nearTheWall)).isGreaterThan(500);
    }

    @Test
    void followingTheLineItGoesRoundTheLoopOfTheStandardRoom() {
        Desk desk = Desk.inTheRoom(HemissonOptions.standard().withSwitches("1101"));
        desk.robot.body().place(new Pose(-2000, -2450, -90));
        double farthestWest = 0;
        double farthestEast = -4000;
        for (int i = 0; i < 1500; i++) {
            desk.after(0.1);
            farthestWest = Math.min(farthestWest, desk.robot.body().pose().xMm());
            farthestEast = Math.max(farthestEast, desk.robot.body().pose().xMm());
        }
        assertThat(farthestWest).isBetween(-3000.0, -2800.0);
        assertThat(farthestEast).isBetween(-1200.0, -1000.0);
    }

    private static Desk desk(String switches) {
        return new Desk(HemissonOptions.standard().withSwitches(switches));
    }
}
