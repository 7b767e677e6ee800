package majicsim.hemisson.modules;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.List;
import java.util.stream.IntStream;
import majicsim.hemisson.Desk;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;

/** Sheet 9: extension modules, as K-Team's firmware reaches them. */
class ModulesTest {
    private final Desk desk = Desk.inTheRoom(HemissonOptions.standard().withModules(EnumSet.allOf(ModuleKind.class)));

    @Test
    void aScanFindsThemByAddress() {
        assertThat(desk.ask("J")).isEqualTo("j,a0,c0,c4,d0,e0");
    }

    @Test
    void whatIsNotThereReads255AndTakesAnything() {
        assertThat(desk.ask("R,B0,00,03")).isEqualTo("r,255,255,255");
        assertThat(desk.ask("W,B0,00,03")).isEqualTo("w");
    }

    @Test
    void registersKeepWhatIsWrittenAndALowerCaseDigitIsMisread() {
        assertThat(desk.ask("W,C0,21,0A") + desk.ask("R,C0,21,01")).isEqualTo("wr,010");
        assertThat(desk.ask("W,C0,21,0a") + desk.ask("R,C0,21,01")).isEqualTo("wr,042");
        assertThat(desk.ask("Y,C0,20,02,41,42") + desk.ask("R,C0,20,03")).isEqualTo("yr,002,065,066");
    }

    @Test
    void theCameraSeesABoxAsABrighterStretch() {
        desk.robot.body().place(new Pose(1500, 2000, 0));
        List<Integer> pixels = values(desk.ask("R,C0,10,66"));
        assertThat(pixels).hasSize(102);
        assertThat(pixels.get(51)).isGreaterThan(110);
        assertThat(pixels.get(0)).isLessThan(20);
        desk.ask("W,C0,20,6E");
        assertThat(values(desk.ask("R,C0,11,66")))
                .containsOnly(0, 255)
                .startsWith(0)
                .endsWith(0);
    }

    @Test
    void aLongerExposureBrightens() {
        int before = values(desk.ask("R,C0,10,01")).get(0);
        desk.ask("W,C0,21,02");
        assertThat(values(desk.ask("R,C0,10,01")).get(0)).isEqualTo(Math.min(255, before * 2));
    }

    @Test
    void thePingsEchoesStandAfter65Milliseconds() {
        desk.robot.body().place(new Pose(2000, 2000, 0));
        assertThat(desk.ask("R,E0,00,01")).isEqualTo("r,006");
        desk.ask("W,E0,00,51");
        assertThat(desk.ask("R,E0,02,02")).isEqualTo("r,255,255");

        desk.after(0.065);

        assertThat(desk.ask("R,E0,02,02")).isEqualTo("r,000,090");
        assertThat(desk.ask("R,E0,01,01")).isEqualTo("r,038");
    }

    @Test
    void aPingReportsInchesAndMicrosecondsTooAndItsRangeCanBeCut() {
        desk.robot.body().place(new Pose(2000, 2000, 0));
        assertThat(ping("50")).isEqualTo("r,000,035");
        assertThat(ping("52")).isEqualTo("r,020,128");
        desk.ask("W,E0,02,0A");
        assertThat(ping("51")).isEqualTo("r,000,000");
    }

    @Test
    void theVoiceSpeaksStoredPhrasesAndIsBusyMeanwhile() {
        assertThat(desk.ask("W,C4,00,07")).isEqualTo("w");
        assertThat(desk.ask("R,C4,00,01")).isEqualTo("r,255");
        desk.after(2);
        assertThat(desk.ask("R,C4,00,01")).isEqualTo("r,000");
        assertThat(desk.robot.handling().said()).containsExactly("phrase 7");
    }

    @Test
    void theCountThatYSendsInFrontOfATextIsTakenForAPhrase() {
        desk.ask("Y,C4,00,06,00,05,03,48,69,00");
        assertThat(desk.robot.handling().said()).containsExactly("phrase 6");
    }

    @Test
    void theDisplayShowsWhatYWrites() {
        desk.ask("Y,A0,10,02,48,69");
        desk.ask("Y,A0,23,03,31,32,33");
        assertThat(desk.robot.handling().shown()).containsExactly("Hi              ", "             123");
        desk.ask("W,A0,11,00");
        assertThat(desk.robot.handling().shown()).containsExactly(" ".repeat(16), "             123");
        desk.robot.handling().holdLcdKeys(5);
        assertThat(desk.ask("R,A0,10,01")).isEqualTo("r,005");
    }

    @Test
    void generalInputAndOutputReadsLevelsAndVoltages() {
        desk.robot.handling().analogueInput(2, 130);
        desk.robot.handling().digitalInput(11, true);
        assertThat(desk.ask("R,D0,12,01")).isEqualTo("r,130");
        assertThat(desk.ask("R,D0,30,02")).isEqualTo("r,000,001");
        desk.ask("W,D0,24,01");
        assertThat(desk.robot.handling().digitalLevel(4)).isTrue();
    }

    @Test
    void afterPowerUpModulesComeOneByOne() {
        desk.robot.handling().powerCycle();
        desk.after(0.1);
        assertThat(desk.ask("J")).isEqualTo("j,d0,e0");
        desk.after(1);
        assertThat(desk.ask("J")).isEqualTo("j,c0,d0,e0");
        desk.after(4);
        assertThat(desk.ask("J")).isEqualTo("j,a0,c0,c4,d0,e0");
    }

    private String ping(String unit) {
        desk.ask("W,E0,00," + unit);
        desk.after(0.07);
        return desk.ask("R,E0,02,02");
    }

    private static List<Integer> values(String reply) {
        String[] words = reply.split(",");
        return IntStream.range(1, words.length)
                .mapToObj(i -> Integer.valueOf(words[i]))
                .toList();
    }
}
