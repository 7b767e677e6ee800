package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import majic.bot.MajicBot;
import majic.team.Member;
import majic.text.MarkedTexts;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Tag("jdk")
class PanelsInLabTest {
    /** What panels show without its being a text: values and units of parameters, and what a robot calls itself. */
    private static final Pattern DATA =
            Pattern.compile("\\b(clear|no|off|remote control|mm|mm/s|s|ms|p3dx-sh|MajicSim|S\\.0)\\b");

    @BeforeEach
    void lookAsInTheProgram() throws Exception {
        LaidOutPanel.lookAsInTheProgram();
    }

    @ParameterizedTest
    @CsvSource({
        "320, 240, 8, 8, 3",
        "380, 200, 8, 8, 3",
        "470, 260, 8, 8, 3",
        "800, 600, 30, 30, 33",
        "400, 700, 20, 20, 17"
    })
    void noReadingIsCutOffOnAnyRobotsPanel(int width, int height, int ofTheAibo, int ofThePioneer, int ofTheHemisson)
            throws Exception {
        int[] least = {ofTheAibo, ofThePioneer, ofTheHemisson};
        try (LabRig lab = LabRig.exact().withAllRobots()) {
            lab.run("2 move 300", "3 move 100", "1 set headPan -60");
            for (Member member : lab.team().members()) {
                LaidOutPanel.of(member.bot(), width, height).checkThatNoTextIsCut(least[member.number() - 1]);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"380, 200", "470, 260", "800, 600", "400, 700"})
    void drawingAndReadingsShareThePanelWithoutCoveringEachOther(int width, int height) throws Exception {
        try (LabRig lab = LabRig.exact().withAllRobots()) {
            for (Member member : lab.team().members()) {
                LaidOutPanel.of(member.bot(), width, height).checkThatNothingIsCovered();
            }
        }
    }

    @Test
    void thePanelsSayWhatTheRobotsSay() throws Exception {
        try (LabRig lab = LabRig.exact().withAllRobots()) {
            lab.run("1 set headPan 40", "2 move 300", "3 set beep on");

            assertThat(shown(lab, 1, "headPan")).isEqualTo("40°");
            assertThat(shown(lab, 2, "x"))
                    .isEqualTo(lab.team().members().get(1).bot().get("x").toString());
            assertThat(shown(lab, 3, "beep")).isEqualTo("on");
        }
    }

    @Test
    void everyPartHasANameAndEnoughContrastInBothLooks() throws Exception {
        try (LabRig lab = LabRig.exact().withAllRobots()) {
            LaidOutPanel.checkNamesAndContrast(bots(lab), 800, 600);
        }
    }

    @Test
    @SuppressWarnings("try")
    void everyTextIsFromAResourceBundle() throws Exception {
        Locale before = Locale.getDefault();
        try (MarkedTexts marked = new MarkedTexts();
                LabRig lab = LabRig.exact().withAllRobots()) {
            Locale.setDefault(marked.language());
            for (MajicBot bot : bots(lab)) {
                assertThat(LaidOutPanel.of(bot, 800, 600).unmarked(DATA)).isEmpty();
            }
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void thePioneersMapKeepsItsRoomInASmallTab() throws Exception {
        try (LabRig lab = LabRig.exact().withAllRobots()) {
            assertThat(LaidOutPanel.of(bots(lab).get(1), 320, 240).drawingSide())
                    .isGreaterThan(100);
        }
    }

    private static List<MajicBot> bots(LabRig lab) {
        return lab.team().members().stream().map(Member::bot).toList();
    }

    private static String shown(LabRig lab, int number, String reading) throws Exception {
        return LaidOutPanel.of(bots(lab).get(number - 1), 800, 600).text(reading);
    }
}
