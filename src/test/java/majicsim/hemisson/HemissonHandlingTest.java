package majicsim.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HemissonHandlingTest {
    private final Desk desk = Desk.inTheRoom(HemissonOptions.standard());
    private final HemissonHandling handling = desk.robot.handling();

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "1;e,05,10",
                "2;e,10,10",
                "3;e,10,05",
                "4;e,-10,10",
                "5;e,00,00",
                "6;e,10,-10",
                "7;e,-5,-10",
                "8;e,-10,-10",
                "9;e,-10,-5",
                "0;e,03,03",
                "63;e,03,03"
            })
    void keysOfTheTvRemoteDrivePastTheSerialLine(int key, String speeds) {
        desk.ask("D,3,3");
        handling.pressTvKey(key);
        assertThat(desk.ask("E")).isEqualTo(speeds);
        assertThat(desk.ask("T")).isEqualTo(String.format(Locale.ROOT, "t,%03d", key));
    }

    @Test
    void aResetForgetsTheTvKey() {
        handling.pressTvKey(5);
        desk.ask("Z");
        desk.after(0.02);
        assertThat(desk.ask("T")).isEqualTo("t,000");
    }

    @Test
    void inAnotherModeAKeyIsTakenDownAndDrivesNothing() {
        Desk held = new Desk(HemissonOptions.standard().withSwitches("0111"));
        held.robot.handling().pressTvKey(2);
        assertThat(held.ask("T") + held.ask("E")).isEqualTo("t,002e,00,00");
    }

    @Test
    void aLiftedRobotStaysWhereItIsAndDrivesOnWhenItIsPutDown() {
        desk.ask("D,5,5");
        handling.lift(true);
        Pose held = desk.robot.body().pose();
        desk.after(1);
        assertThat(desk.robot.body().pose()).isEqualTo(held);
        handling.lift(false);
        desk.after(1);
        assertThat(desk.robot.body().pose().xMm()).isGreaterThan(held.xMm() + 85);
    }

    @Test
    void theOnOffLedIsResetByTheHeartbeatAndTheOthersAreNot() {
        Set<Boolean> onOff = new HashSet<>();
        desk.ask("L,1,1,1,0");
        for (int i = 0; i < 12; i++) {
            desk.after(0.1);
            onOff.add(handling.leds().get(0));
            assertThat(handling.leds().subList(1, 4)).containsExactly(true, true, false);
        }
        assertThat(onOff).containsExactlyInAnyOrder(true, false);
    }

    @Test
    void inBrightLightEverythingLooksFar() {
        desk.robot.body().place(new Pose(4500 - 57.5 - 10, 0, 0));
        desk.after(0.044);
        assertThat(desk.ask("N")).startsWith("n,150,");

        handling.lighten(20);
        desk.after(0.044);

        assertThat(desk.ask("O")).isEqualTo("o,020,020,020,020,020,020,020,020");
        assertThat(desk.ask("N")).startsWith("n,020,");
    }

    @Test
    void theEyeThatLooksAtALampReadsLess() {
        desk.robot.body().place(new Pose(-500, -2600, 0));
        desk.after(0.044);
        assertThat(desk.ask("M,0") + desk.ask("M,1")).isEqualTo("m,157,169,169m,205,205,207");
    }

    @Test
    void overTapeTheGroundEyesReadMuchLess() {
        desk.robot.body().place(new Pose(-2000, -2600 + 57, -90));
        desk.after(0.044);
        assertThat(desk.ask("P,2")).isEqualTo("p,013,013");
    }

    @Test
    void whatCannotBeDoneIsRefused() {
        assertThatThrownBy(() -> handling.pressTvKey(64)).hasMessage("key must be 0 to 63, not 64");
        assertThatThrownBy(() -> handling.lighten(-1)).hasMessage("reading must be 0 to 255, not -1");
        assertThatThrownBy(() -> handling.moveSwitches("12"))
                .hasMessage("switches must be four characters 0 or 1, not '12'");
    }

    @Test
    void aPinIsAnInputOnceItIsReadAndAnOutputOnceItIsSet() {
        handling.pinInput(1, true);
        assertThat(desk.ask("2,1,0")).isEqualTo("2");
        assertThat(handling.pinLevel(1)).isFalse();

        assertThat(desk.ask("1,1")).isEqualTo("1,1");
        assertThat(handling.pinLevel(1)).isTrue();
    }
}
