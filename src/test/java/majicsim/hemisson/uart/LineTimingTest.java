package majicsim.hemisson.uart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Locale;
import java.util.Set;
import majicsim.hemisson.Desk;
import majicsim.hemisson.modules.ModuleKind;
import majicsim.hemisson.options.HemissonOptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Sheet 4.4 and 4.6: what characters take on the wire, and what happens to those that come too early. */
class LineTimingTest {
    private static final double TICK_SECONDS = 10e-6;
    private static final double CHARACTER_SECONDS = 88e-6;
    private static final HemissonOptions CAMERA =
            HemissonOptions.standard().withModules(Set.of(ModuleKind.CAMERA)).paced();
    private static final HemissonOptions TRUE_RECEIVER =
            HemissonOptions.standard().withOverrun();

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "D,1,1 | 0.31",
                "H,0 | 0.3",
                "L,1,1,1,1 | 0.3",
                "E | 0.81",
                "T | 0.64",
                "I | 0.99",
                "P,0 | 1.4",
                "B | 1.52",
                "& | 2.2",
                "N | 3.10",
                "O | 3.10",
                "R,C0,10,FF | 90.4",
                "R,C0,10,66 | 37",
                "Z | 14",
            })
    void theEndOfAReplyComesAtTheTimeInTheSheet(String command, double ms) {
        assertThat(endOfReplyMs(new Desk(CAMERA), command)).isCloseTo(ms, within(Math.max(0.06, ms * 0.02)));
    }

    @Test
    void aScanOfTheBusTakes18Milliseconds() {
        Desk bare = new Desk(HemissonOptions.standard().paced());
        assertThat(endOfReplyMs(bare, "J")).isCloseTo(18, within(0.2));
    }

    @ParameterizedTest
    @CsvSource({"B,0.03", "'R,C0,00,01',0.4", "'W,C0,21,01',0.4"})
    void theFirstCharacterComesSoonAfterTheLastOfTheCommand(String command, double ms) {
        Desk desk = new Desk(CAMERA);
        desk.say(command + "␍");
        double firstMs = ticksUntil(desk, "") - CHARACTER_SECONDS * 1000 * (command.length() + 2);
        assertThat(firstMs).isCloseTo(ms, within(0.03));
    }

    @Test
    void halfAReplyIsOutAfterHalfItsTime() {
        Desk desk = new Desk(HemissonOptions.standard().paced());
        desk.say("N␍");
        String begin = desk.tick(0.0018);
        assertThat(begin).startsWith("n,004,").hasSizeBetween(16, 18);
        assertThat(begin + desk.tick(0.002)).isEqualTo("n,004,004,004,004,004,004,060,060␍␊");
    }

    @ParameterizedTest
    @ValueSource(strings = {"E␍E␍E␍", "E␍D,1,2␍", "B␍j␍N␍O␍", "N␍D,0,0␍"})
    void aThirdCharacterThatWaitsBlocksTheReceiverForGoodAndTheWheelsTurnOn(String burst) {
        Desk desk = new Desk(TRUE_RECEIVER);
        desk.ask("D,5,5");

        desk.say(burst);
        desk.after(1);

        assertThat(desk.robot.handling().isReceiverBlocked()).isTrue();
        assertThat(desk.robot.body().pose().xMm()).isGreaterThan(Desk.START.xMm() + 85);
        assertThat(desk.ask("B")).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "D,5,5 | 0",
                "H,1 | 0",
                "L,1,1,1,1 | 0",
                "T | 0.24",
                "E | 0.40",
                "I | 0.58",
                "B | 1.10",
                "N | 2.70",
            })
    void theNextCommandSurvivesFromTheMomentThatWasMeasuredOn(String command, double ms) {
        assertThat(survives(command, ms + 0.02)).isTrue();
        assertThat(survives(command, ms - 0.04)).isEqualTo(ms == 0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"D,5,5␍D,0,0␍D,5,5␍", "H,1␍H,0␍", "D,5,5␍D,0,0␍D,5,5␍D,1,1␍D,2,2␍"})
    void briefAnswersLetTheNextCommandFollowInTheSameWrite(String burst) {
        Desk desk = new Desk(TRUE_RECEIVER);
        desk.say(burst);
        String letters = burst.toLowerCase(Locale.ROOT).replaceAll("[^dh]", "").replaceAll(".", "$0␍␊");
        assertThat(desk.after(0.02)).isEqualTo(letters);
        assertThat(desk.robot.handling().isReceiverBlocked()).isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"T␍T␍T␍", "␍␍␍␍␍␍"})
    void afterALongerAnswerOnlyTwoCharactersAreStillTaken(String burst) {
        Desk desk = new Desk(TRUE_RECEIVER);
        desk.say(burst);
        desk.after(0.1);
        assertThat(desk.robot.handling().isReceiverBlocked()).isTrue();
    }

    @Test
    void theTwoCharactersInAReceiverThatOverflowsAreStillTaken() {
        Desk desk = new Desk(TRUE_RECEIVER);
        desk.say("E␍E␍E␍");
        assertThat(desk.after(0.02)).isEqualTo("e,00,00␍␊e,00,00␍␊");
        assertThat(desk.ask("E")).isEmpty();
    }

    @Test
    void aCharacterThatIsTakenTogetherWithTheEndOfACommandHidesIt() {
        Desk desk = new Desk(TRUE_RECEIVER);
        desk.say("N␍");
        desk.tick(0.0005);
        desk.say("␍B");
        desk.tick(0.01);
        assertThat(desk.ask("")).isEqualTo("Unknown Command ?!");
    }

    @Test
    void twoThatWaitAreAnswered() {
        Desk desk = new Desk(TRUE_RECEIVER);
        desk.say("N␍O␍");
        assertThat(desk.after(0.012))
                .isEqualTo("n,004,004,004,004,004,004,060,060␍␊o,220,220,220,220,220,220,220,220␍␊");
    }

    @Test
    void oneQuestionAfterTheOtherNeverBlocksTheReceiver() {
        Desk desk = new Desk(TRUE_RECEIVER);
        for (int i = 0; i < 1500; i++) {
            assertThat(desk.ask("D,3,-3") + desk.ask("E")).isEqualTo("de,03,-3");
        }
    }

    @Test
    void whatComesWhileItStartsBlocksTheTrueReceiverAndWaitsForTheForgivingOne() {
        Desk hard = new Desk(TRUE_RECEIVER);
        Desk kind = new Desk(HemissonOptions.standard());

        hard.say("Z␍");
        hard.after(0.004);
        hard.say("E␍E␍");
        kind.say("Z␍E␍E␍");
        hard.after(0.02);

        assertThat(hard.robot.handling().isReceiverBlocked()).isTrue();
        assertThat(kind.after(0.02)).endsWith("␍␊␍␊e,00,00␍␊e,00,00␍␊");
    }

    /**
     * Whether the robot still receives after a command whose first character was sent so long after the CR of the one
     * before.
     */
    private static boolean survives(String command, double laterMs) {
        Desk desk = new Desk(TRUE_RECEIVER);
        desk.say(command + "␍");
        desk.tick(CHARACTER_SECONDS * (command.length() + 1) + laterMs / 1000);
        desk.say("D,1,1␍");
        desk.tick(0.02);
        return desk.ask("E").equals("e,01,01");
    }

    private static double endOfReplyMs(Desk desk, String command) {
        desk.say(command + "␍");
        double arrivedMs = CHARACTER_SECONDS * 1000 * (command.length() + 1);
        return ticksUntil(desk, command.equals("Z") ? "com␍␊␍␊" : "␍␊") - arrivedMs;
    }

    /** Until the received text ends as given. */
    private static double ticksUntil(Desk desk, String end) {
        String heard = "";
        int ticks = 0;
        while (heard.isEmpty() || !heard.endsWith(end)) {
            heard += desk.tick(TICK_SECONDS);
            assertThat(++ticks).isLessThan(10_000);
        }
        return ticks * TICK_SECONDS * 1000;
    }
}
