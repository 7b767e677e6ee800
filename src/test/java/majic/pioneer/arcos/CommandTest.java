package majic.pioneer.arcos;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.charset.StandardCharsets;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class CommandTest {
    static Stream<Arguments> examplesOfTheSheet() {
        return Stream.of(
                Arguments.of("FA FB 06 04 3B 01 00 05 3B", Command.ENABLE.packet(1)),
                Arguments.of("FA FB 06 0B 3B FA 00 05 3B", Command.VEL.packet(250)),
                Arguments.of("FA FB 06 0B 1B C8 00 D3 1B", Command.VEL.packet(-200)),
                Arguments.of("FA FB 06 0C 3B 5A 00 66 3B", Command.HEAD.packet(90)),
                Arguments.of("FA FB 06 12 3B 01 00 13 3B", Command.CONFIG.packet(1)),
                Arguments.of("FA FB 06 08 3B 2C 01 34 3C", Command.MOVE.packet(300)),
                Arguments.of("FA FB 06 02 3B 01 00 03 3B", Command.CLOSE.packet(1)),
                Arguments.of("FA FB 06 20 3B 0A 05 2A 40", Command.VEL2.packet(10, 5)),
                Arguments.of("FA FB 06 20 3B 0A FB 2B 36", Command.VEL2.packet(10, -5)),
                Arguments.of("FA FB 03 00 00 00", Command.PULSE.packet()),
                Arguments.of("FA FB 03 01 00 01", Frame.bare(1)),
                Arguments.of(
                        "FA FB 07 EE 2B 02 68 69 F0 FA", Frame.string(0xEE, "hi".getBytes(StandardCharsets.US_ASCII))));
    }

    static Stream<Arguments> sentByTheMakersClient() {
        return Stream.of(
                Arguments.of("FA FB 06 06 3B B8 0B BE 46", Command.SETV.packet(3000)),
                Arguments.of("FA FB 06 05 3B 2C 01 31 3C", Command.SETA.packet(300)),
                Arguments.of("FA FB 06 05 1B 2C 01 31 1C", Command.SETA.packet(-300)),
                Arguments.of("FA FB 06 0A 3B 96 00 A0 3B", Command.SETRV.packet(150)),
                Arguments.of("FA FB 06 17 3B 64 00 7B 3B", Command.SETRA.packet(100)),
                Arguments.of("FA FB 06 17 1B 64 00 7B 1B", Command.SETRA.packet(-100)),
                Arguments.of("FA FB 06 01 3B 01 00 02 3B", Command.OPEN.packet(1)),
                Arguments.of("FA FB 06 3E 3B 01 00 3F 3B", Command.BATTERYINFO.packet(1)));
    }

    @ParameterizedTest
    @MethodSource({"examplesOfTheSheet", "sentByTheMakersClient"})
    void commandsAreBuiltAsTheSheetHasThem(String expected, byte[] packet) {
        assertThat(Bytes.hex(packet)).isEqualTo(expected);
    }

    @Test
    void aCommandRefusesAnArgumentOfAnotherKind() {
        assertThatIllegalArgumentException().isThrownBy(Command.VEL::packet);
        assertThatIllegalArgumentException().isThrownBy(() -> Command.PULSE.packet(1));
    }

    @Test
    void numbersThatDoNotFitAreRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> Command.VEL.packet(70_000));
        assertThatIllegalArgumentException().isThrownBy(() -> Command.TTY2.packet(new byte[200]));
    }
}
