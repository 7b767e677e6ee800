package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.TimeSource;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Command;
import org.junit.jupiter.api.Test;

class ArcosLineTest {

    @Test
    void everyPacketIsOneWrite() {
        RecordingLink link = new RecordingLink();
        ArcosLine line = new ArcosLine(link, TimeSource.system());

        line.send(Ramps.careful(Limits.of(Models.USUAL, null)).packets());
        line.sendIfPossible(Command.VEL.packet(0), Command.RVEL.packet(0));

        assertThat(link.written).hasSize(8).allSatisfy(write -> {
            assertThat(write).startsWith(0xFA, 0xFB).hasSize((write[2] & 0xFF) + 3);
            assertThat(Bytes.packets(Bytes.hex(write))).hasSize(1);
        });
    }
}
