package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.groups.Tuple.tuple;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What is plugged into a stock robot, and the exact commands that reach it (Hemisson sheet 9 and 14). */
class ModulesTest {
    @AutoClose
    private final DrivenHemisson pair = new DrivenHemisson();

    private final ScriptedHemisson robot = pair.robot();
    private final MajicHemisson bot = pair.bot();

    @BeforeEach
    void plugAllIn() {
        robot.answer('J', command -> "j,a0,c0,c4,d0,e0");
        robot.answer('W', command -> "w");
        robot.answer('Y', command -> "y");
        robot.answer('R', ModulesTest::registers);
        robot.answer('1', command -> "1,1");
        robot.answer('2', command -> "2");
        bot.connect();
    }

    private static String registers(String command) {
        int count = Integer.parseInt(command.substring(8), 16);
        return switch (command) {
            case "R,E0,01,03" -> "r,150,001,044";
            case "R,E0,02,22" -> "r,001,044,002,000" + ",000".repeat(30);
            default -> "r" + IntStream.range(0, count).mapToObj(index -> ",010").collect(Collectors.joining());
        };
    }

    @Test
    void tellsWhatItFound() {
        assertThat(bot.get("modules").toString())
                .isEqualTo(
                        "LCD at A0, linear camera at C0, text to speech at C4, general I/O at D0, ultrasonic sensor at E0");
    }

    @Test
    void anEchoIsMeasuredByAPingAndAReading() {
        assertThat(bot.get("ultrasonic")).hasToString("3000 mm");
        assertThat(bot.get("ultrasonicLight")).hasToString("150");
        assertThat(bot.get("ultrasonicEchoes")).hasToString("3000 mm, 5120 mm");
        assertThat(robot.commands()).containsSubsequence("W,E0,00,51", "R,E0,01,03");
    }

    @Test
    void theCameraReturnsItsPixels() {
        Value.Many pixels = (Value.Many) bot.get("camera");
        bot.set("cameraExposure", 10);

        assertThat(pixels.values()).hasSize(102);
        assertThat(bot.get("cameraExposure")).hasToString("10 ms");
        assertThat(robot.commands()).contains("R,C0,10,66", "W,C0,21,0A", "R,C0,21,01");
    }

    @Test
    void theCameraIsNotReadWhileItMoves() {
        bot.drive(42, 0);

        assertThatThrownBy(() -> bot.get("camera")).hasMessageContaining("while the robot moves");
        assertThat(robot.commands()).doesNotContain("R,C0,10,66");
    }

    @Test
    void textIsSentToTheDisplayAndPhrasesToTheSpeechModule() {
        run("lcd", "upper", "AB");
        run("phrase", "7");

        assertThat(robot.commands()).contains("Y,A0,10,02,41,42", "W,C4,00,07");
        assertThatThrownBy(() -> run("lcd", "upper", "much too long a text"))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("1 to 13 letters");
    }

    @Test
    void digitalLinesAndPinsAreReadAndSet() {
        bot.set("digital11", "on");
        bot.set("pinRB7", "on");

        assertThat(bot.get("analog4")).hasToString("10");
        assertThat(bot.get("pinRB7").isYes()).isTrue();
        assertThat(bot.get("pinRB6").isYes()).isTrue();
        assertThat(robot.commands())
                .contains("W,D0,31,01", "R,D0,14,01", "2,2,1", "1,1")
                .doesNotContain("1,2");
    }

    @Test
    void rawReadingAndWritingIsPassedOn() {
        assertThat(run("i2cRead", "c0", "20", "3")).isEqualTo("10, 10, 10");
        run("i2cWrite", "C0", "20", "41", "42");

        assertThat(robot.commands()).contains("R,C0,20,03", "Y,C0,20,02,41,42");
        assertThatThrownBy(() -> run("i2cRead", "C1", "0", "1")).hasMessageContaining("even");
    }

    @Test
    void onlyRawWritingNeedsThePermissionToMove() {
        assertThat(bot.commands())
                .filteredOn(command -> command.name().startsWith("i2c"))
                .extracting(BotCommand::name, BotCommand::moves)
                .containsExactly(tuple("i2cRead", false), tuple("i2cWrite", true));
    }

    private String run(String command, String... words) {
        return bot.run(
                command,
                List.of(words).stream()
                        .map(word ->
                                word.matches("[1-9]") ? Value.of(Integer.parseInt(word), Unit.NONE) : Value.text(word))
                        .toList());
    }
}
