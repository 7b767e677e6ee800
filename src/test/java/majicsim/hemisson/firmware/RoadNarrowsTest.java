package majicsim.hemisson.firmware;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.Set;
import majicsim.hemisson.Desk;
import majicsim.hemisson.modules.ModuleKind;
import majicsim.hemisson.options.Dialect;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Sheet 10: the RoadNarrows dialect. */
class RoadNarrowsTest {
    private static final HemissonOptions OPTIONS = HemissonOptions.standard()
            .withDialect(Dialect.ROADNARROWS)
            .withModules(EnumSet.of(ModuleKind.CAMERA, ModuleKind.ULTRASONIC, ModuleKind.SPEECH));

    private final Desk desk = new Desk(OPTIONS);

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "B | b,HemiOS_v_1.50-RNe",
                "D,5,-5 | d,5,-5",
                "H,1 | h,1",
                "L,1,0,1,0 | l,1,0,1,0",
                "J | j,L,C0,01,T,C4,07,U,E0,06",
                "I | i,1,1,1,1",
                "N | n,004,004,004,004,004,004,060,060",
                "O | o,220,220,220,220,220,220,220,220",
                "K | <E01: unknown command>",
                "b | <E01: unknown command>",
                "D,5 | <E02: bad syntax>",
                "H,2 | <E02: bad syntax>",
                "D,12,12 | <E16: value out of range>",
                "D,5,123456789012 | <E16: value out of range>",
                "A | <E02: bad syntax>",
                "A,Z,V | <E11: bad module id>",
                "A,G,V | <E13: module not supported>",
                "A,U,Z | <E17: unknown module command>",
                "A,L,P,4 | <E16: value out of range>",
                "A,L,E,xy | <E02: bad syntax>",
                "A,L,V | a,L,V,01",
                "A,L,E,0A | a,L,E,0A",
                "A,L,E,0a | a,L,E,0a",
                "A,L,E,0g | <E02: bad syntax>",
                "A,L,L,1 | a,L,L,1",
                "A,U,V | a,U,V,06",
                "A,U,U,I | a,U,U,I",
                "A,U,R,0BB8 | a,U,R,0BB8",
                "A,U,R,0bb8 | a,U,R,0bb8",
                "A,U,E,17 | <E16: value out of range>",
                "A,T,V | a,T,V,07",
                "A,T,Q | a,T,Q,0",
                "A,T,G,3 | a,T,G,3",
                "A,T,S,  | <E15: bad length>",
            })
    void answersAsInTheSheet(String sent, String received) {
        assertThat(desk.ask(sent)).isEqualTo(received);
    }

    @Test
    void speedsAreReportedUnscaled() {
        assertThat(desk.ask("D,-9,3") + desk.ask("E")).isEqualTo("d,-9,3e,-9,3");
    }

    @Test
    void aCommandThatIsTooLongIsRefusedAndTheNextOneIsNot() {
        assertThat(desk.say("x".repeat(200) + "␍B␍")).isEqualTo("<E03: command too long>␍␊b,HemiOS_v_1.50-RNe␍␊");
    }

    @Test
    void aResetGreetsWithItsName() {
        desk.say("Z␍");
        assertThat(desk.after(0.02)).startsWith("HemiOS V1.50-RNe , K-Team S.A.");
    }

    @Test
    void theCameraGivesThirdsOfItsPicture() {
        String all = desk.ask("A,L,P,0");
        assertThat(all).matches("a,L,P,0,[0-9A-F]{204}");
        String pixels = all.substring("a,L,P,0,".length());
        assertThat(desk.ask("A,L,P,2")).isEqualTo("a,L,P,2," + pixels.substring(68, 136));
        assertThat(desk.ask("A,L,Q,3")).matches("a,L,Q,3,(00|FF){34}");
    }

    @Test
    void whatIsSetCanBeRead() {
        desk.ask("A,L,E,05");
        desk.ask("A,L,T,60");
        assertThat(desk.ask("A,L,F") + desk.ask("A,L,U")).isEqualTo("a,L,F,05a,L,U,60");
    }

    @Test
    void lowerCaseHexDigitsAreReadAsTheirUpperCase() {
        desk.ask("A,L,E,0a");
        desk.ask("W,c0,20,3c");

        assertThat(desk.ask("A,L,F") + desk.ask("R,c0,20,01")).isEqualTo("a,L,F,0Ar,060");
    }

    @Test
    void measuringIsAnsweredWhenItIsDone() {
        desk.robot.body().place(new Pose(2000, 2000, 0));
        desk.say("A,U,M␍");
        assertThat(desk.after(0.06)).isEmpty();
        assertThat(desk.after(0.008)).isEqualTo("a,U,M␍␊");
        assertThat(desk.ask("A,U,E,00")).isEqualTo("a,U,E,00,005A");
        assertThat(desk.ask("A,U,A")).matches("a,U,A,005A(,[0-9A-F]{4}){16}");
        assertThat(desk.ask("A,U,L")).isEqualTo("a,U,L,26");
    }

    @Test
    void aTextIsSpokenAndABusyVoiceReportsIt() {
        String text = "yes, this is a text of seventy-two characters, as long as it may get !!";
        assertThat(desk.ask("A,T,S," + text)).isEqualTo("a,T,S," + text);
        assertThat(desk.ask("A,T,Q")).isEqualTo("a,T,Q,1");
        assertThat(desk.ask("A,T,C,5")).isEqualTo("<E14: module busy>");
        assertThat(desk.robot.handling().said()).containsExactly(text);
    }

    @Test
    void aModuleThatIsNotFittedIsNotConnected() {
        Desk bare = new Desk(OPTIONS.withModules(Set.of()));
        assertThat(bare.ask("J")).isEqualTo("j");
        assertThat(bare.ask("A,L,V")).isEqualTo("<E12: module not connected>");
    }
}
