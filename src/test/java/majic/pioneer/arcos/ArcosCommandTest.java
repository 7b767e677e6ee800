package majic.pioneer.arcos;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

class ArcosCommandTest {
    static Stream<Arguments> examplesOfTheSheet() {
        return Stream.of(
                Arguments.of("FA FB 06 04 3B 01 00 05 3B", ArcosCommand.ENABLE.packet(1)),
                Arguments.of("FA FB 06 0B 3B FA 00 05 3B", ArcosCommand.VEL.packet(250)),
                Arguments.of("FA FB 06 0B 1B C8 00 D3 1B", ArcosCommand.VEL.packet(-200)),
                Arguments.of("FA FB 06 0C 3B 5A 00 66 3B", ArcosCommand.HEAD.packet(90)),
                Arguments.of("FA FB 06 12 3B 01 00 13 3B", ArcosCommand.CONFIG.packet(1)),
                Arguments.of("FA FB 06 08 3B 2C 01 34 3C", ArcosCommand.MOVE.packet(300)),
                Arguments.of("FA FB 06 02 3B 01 00 03 3B", ArcosCommand.CLOSE.packet(1)),
                Arguments.of("FA FB 06 20 3B 0A 05 2A 40", ArcosCommand.VEL2.packet(10, 5)),
                Arguments.of("FA FB 06 20 3B 0A FB 2B 36", ArcosCommand.VEL2.packet(10, -5)),
                Arguments.of("FA FB 06 20 3B F6 04 16 3F", ArcosCommand.VEL2.packet(-10, 4)),
                Arguments.of("FA FB 06 1E 3B 05 0F 23 4A", ArcosCommand.DIGOUT.packet(0x05, 0x0F)),
                Arguments.of("FA FB 03 07 00 07", ArcosCommand.SETO.packet()),
                Arguments.of("FA FB 07 0F 2B 02 0A 48 11 7D", ArcosCommand.SAY.packet(new byte[] {10, 72})),
                Arguments.of("FA FB 03 00 00 00", ArcosCommand.PULSE.packet()),
                Arguments.of("FA FB 03 01 00 01", Packet.bare(1)),
                Arguments.of(
                        "FA FB 07 EE 2B 02 68 69 F0 FA",
                        Packet.ofString(0xEE, "hi".getBytes(StandardCharsets.US_ASCII))));
    }

    static Stream<Arguments> sentByTheMakersClient() {
        return Stream.of(
                Arguments.of("FA FB 06 06 3B B8 0B BE 46", ArcosCommand.SETV.packet(3000)),
                Arguments.of("FA FB 06 05 3B 2C 01 31 3C", ArcosCommand.SETA.packet(300)),
                Arguments.of("FA FB 06 05 1B 2C 01 31 1C", ArcosCommand.SETA.packet(-300)),
                Arguments.of("FA FB 06 0A 3B 96 00 A0 3B", ArcosCommand.SETRV.packet(150)),
                Arguments.of("FA FB 06 17 3B 64 00 7B 3B", ArcosCommand.SETRA.packet(100)),
                Arguments.of("FA FB 06 17 1B 64 00 7B 1B", ArcosCommand.SETRA.packet(-100)),
                Arguments.of("FA FB 06 01 3B 01 00 02 3B", ArcosCommand.OPEN.packet(1)),
                Arguments.of("FA FB 06 3E 3B 01 00 3F 3B", ArcosCommand.BATTERYINFO.packet(1)));
    }

    @ParameterizedTest
    @MethodSource({"examplesOfTheSheet", "sentByTheMakersClient"})
    void commandsAreBuiltAsTheSheetHasThem(String expected, Packet packet) {
        assertThat(Bytes.hex(packet.bytes())).isEqualTo(expected);
    }

    @Test
    void aCommandRefusesAnArgumentOfAnotherKind() {
        assertThatIllegalArgumentException().isThrownBy(ArcosCommand.VEL::packet);
        assertThatIllegalArgumentException().isThrownBy(() -> ArcosCommand.PULSE.packet(1));
        assertThatIllegalArgumentException().isThrownBy(() -> ArcosCommand.VEL.packet(1, 2));
        assertThatIllegalArgumentException().isThrownBy(() -> ArcosCommand.VEL.packet(new byte[2]));
    }

    @ParameterizedTest
    @CsvSource({
        "VEL, 32768, 'VEL takes -32767 to 32767 (mm/s), not 32768'",
        "VEL, -2147483648, 'VEL takes -32767 to 32767 (mm/s), not -2147483648'",
        "SETV, -1, 'SETV takes 0 to 32767 (mm/s), not -1'",
        "ENABLE, 2, 'ENABLE takes 0 to 1 (0 off, 1 on), not 2'",
        "HEAD, 361, 'HEAD takes -360 to 360 (deg), not 361'"
    })
    void aNumberOutOfRangeIsRefusedAndNotCutOff(ArcosCommand command, int value, String complaint) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> command.packet(value))
                .withMessage(complaint);
    }

    @Test
    void bytesOutOfRangeAreRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> ArcosCommand.VEL2.packet(128, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> ArcosCommand.DIGOUT.packet(0, 256));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ArcosCommand.SAY.packet(new byte[41]))
                .withMessage("SAY takes at most 40 bytes, not 41");
    }

    @ParameterizedTest
    @EnumSource
    void theLargestArgumentOfEveryCommandFitsAPacket(ArcosCommand command) {
        ArcosCommand.Argument argument = command.argument();
        Packet packet = switch (argument.kind()) {
            case NONE -> command.packet();
            case INT -> command.packet(argument.most());
            case TWO_BYTES -> command.packet(argument.most(), argument.least());
            case STRING -> command.packet(new byte[argument.most()]);
        };

        byte[] bytes = packet.bytes();
        List<Packet> found = new ArrayList<>();
        new FrameDecoder().feed(bytes, bytes.length, found::add);
        assertThat(bytes).hasSizeLessThanOrEqualTo(200);
        assertThat(found).extracting(Packet::type).containsExactly(command.number());
    }

    @Test
    void noTwoCommandsShareANumber() {
        assertThat(Arrays.stream(ArcosCommand.values()).map(ArcosCommand::number))
                .doesNotHaveDuplicates();
    }
}
