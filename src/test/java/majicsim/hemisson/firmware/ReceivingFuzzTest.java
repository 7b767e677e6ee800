package majicsim.hemisson.firmware;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;
import java.util.EnumSet;
import majicsim.hemisson.Desk;
import majicsim.hemisson.modules.ModuleKind;
import majicsim.hemisson.options.Dialect;
import majicsim.hemisson.options.HemissonOptions;

/**
 * Whatever bytes come from a client: found and kept ones in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class ReceivingFuzzTest {
    private static final HemissonOptions FITTED =
            HemissonOptions.standard().withModules(EnumSet.allOf(ModuleKind.class));

    /** Longer than a start and its greeting take. */
    private static final double START_S = 0.04;

    @FuzzTest
    void theSameIsAnsweredHoweverTheBytesAreCut(byte[] wire) {
        String text = new String(wire, StandardCharsets.ISO_8859_1);
        Desk whole = new Desk(FITTED);
        Desk cut = new Desk(FITTED);

        String answers = whole.say(text);
        StringBuilder pieces = new StringBuilder();
        for (int i = 0; i < text.length(); i++) {
            pieces.append(cut.say(text.substring(i, i + 1)));
        }

        assertThat(pieces).hasToString(answers);
        assertThat(cut.after(START_S)).isEqualTo(whole.after(START_S));
    }

    @FuzzTest
    void afterAnyNoiseSwitchingItOffAndOnHelps(byte[] wire) {
        assertAnswersWhenSwitchedOn(new Desk(FITTED), wire, "b,HemiOS_v_1.50");
    }

    @FuzzTest
    void theTrueReceiverStandsAnyNoiseToo(byte[] wire) {
        assertAnswersWhenSwitchedOn(new Desk(FITTED.withOverrun()), wire, "b,HemiOS_v_1.50");
    }

    @FuzzTest
    void theOtherDialectRefusesUnknownCommandsAndWorksOn(byte[] wire) {
        Desk desk = new Desk(FITTED.withDialect(Dialect.ROADNARROWS));
        assertAnswersWhenSwitchedOn(desk, wire, "b,HemiOS_v_1.50-RNe");
    }

    private static void assertAnswersWhenSwitchedOn(Desk desk, byte[] wire, String version) {
        String text = new String(wire, StandardCharsets.ISO_8859_1);
        for (int at = 0; at < text.length(); at += 7) {
            desk.say(text.substring(at, Math.min(text.length(), at + 7)));
            desk.after(0.02);
        }
        desk.robot.handling().powerCycle();

        assertThat(desk.after(START_S)).startsWith("HemiOS V1.50");
        assertThat(desk.ask("B")).isEqualTo(version);
    }
}
