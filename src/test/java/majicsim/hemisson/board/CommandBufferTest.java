package majicsim.hemisson.board;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import majicsim.hemisson.Desk;
import majicsim.hemisson.modules.ModuleKind;
import majicsim.hemisson.options.HemissonOptions;
import org.junit.jupiter.api.Test;

/** Sheet 4.2: a buffer of 80 bytes, never cleared, that lies across the sensor tables. */
class CommandBufferTest {
    private static final String GREETING =
            "HemiOS V1.50 , K-Team S.A. ( Alexandre Colot )  30-Aug-04 @ 09:37:30␍␊" + "E-Mail : info@hemisson.com␍␊␍␊";

    private final Desk desk = new Desk(HemissonOptions.standard());

    @Test
    void missingArgumentsAreWhatAnEarlierCommandLeft() {
        assertThat(desk.say("H,1␍H␍")).isEqualTo("h␍␊h␍␊");
        assertThat(desk.robot.handling().isBuzzing()).isTrue();
        assertThat(desk.say("D,4,-3␍H␍D␍E␍")).isEqualTo("d␍␊h␍␊d␍␊e,04,-3␍␊");
    }

    @Test
    void aLineOf79CharactersWorksAndOneOf80IsTheLast() {
        assertThat(desk.say("B" + "x".repeat(77) + "␍")).isEqualTo("b,HemiOS_v_1.50␍␊");
        assertThat(desk.say("B" + "x".repeat(78) + "␍B␍")).isEmpty();
        assertThat(desk.robot.handling().isReceiverBlocked()).isTrue();
    }

    @Test
    void onlyThePowerSwitchHelpsAStuckBuffer() {
        desk.say("x".repeat(100) + "␍Z␍");

        desk.robot.handling().powerCycle();

        assertThat(desk.after(0.02)).isEqualTo(GREETING);
        assertThat(desk.ask("B")).isEqualTo("b,HemiOS_v_1.50");
    }

    @Test
    void aCommandOf50CharactersLeavesTheSensorTablesAlone() {
        desk.say("B" + "x".repeat(48) + "␍");
        assertThat(desk.say("N␍")).isEqualTo("n,004,004,004,004,004,004,060,060␍␊");
    }

    @Test
    void aLongerCommandShowsInTheSensorsUntilTheyAreReadAnew() {
        desk.say("B" + "x".repeat(49) + "AB␍");
        assertThat(desk.say("O␍")).isEqualTo("o,013,065,066,220,220,220,220,220␍␊");
        desk.say("B" + "x".repeat(57) + "abcdefgh" + "␍");
        assertThat(desk.say("N␍")).isEqualTo("n,099,097,098,102,101,100,104,103␍␊");

        desk.after(0.044);

        assertThat(desk.say("N␍")).isEqualTo("n,004,004,004,004,004,004,060,060␍␊");
    }

    @Test
    void sensorsThatAreReadWhileALongCommandComesSpoilIt() {
        HemissonOptions withCamera = HemissonOptions.standard().withModules(Set.of(ModuleKind.CAMERA));
        Desk camera = new Desk(withCamera);
        String values = ",01".repeat(20);
        camera.say("Y,C0,40,14" + values);

        camera.after(0.044);

        assertThat(camera.say("␍")).isEqualTo("y␍␊");
        assertThat(camera.say("R,C0,4D,03␍")).startsWith("r,001,").isNotEqualTo("r,001,001,001␍␊");
    }
}
