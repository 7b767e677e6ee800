package majic.pioneer.line;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import majic.bot.LinkLost;
import majic.driver.ReplayLink;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Packet;
import majic.pioneer.state.Limits;
import majic.pioneer.state.Models;
import majic.pioneer.state.Ramps;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class ArcosLineTest {

    @Test
    void everyPacketIsOneWrite() {
        RecordingLink link = new RecordingLink();
        ArcosLine line = new ArcosLine(link, TimeSource.system());

        line.send(Ramps.careful(Limits.of(Models.USUAL, null)).packets());
        line.sendIfPossible(ArcosCommand.VEL.packet(0), ArcosCommand.RVEL.packet(0));

        assertThat(link.written).hasSize(8).allSatisfy(write -> {
            assertThat(write).startsWith(0xFA, 0xFB).hasSize((write[2] & 0xFF) + 3);
            assertThat(Bytes.packets(Bytes.hex(write))).hasSize(1);
        });
    }

    @Test
    @Timeout(20)
    void anErrorOverOnePacketLeavesTheLineToTheNextOnes() throws InterruptedException {
        List<Integer> taken = new CopyOnWriteArrayList<>();
        CountDownLatch ended = new CountDownLatch(1);
        ReplayLink link = new ReplayLink(Bytes.wire(0x32, new byte[1]), Bytes.wire(0x33, new byte[1]));

        new ArcosLine(link, TimeSource.system()).open(new ArcosLine.Listener() {
            @Override
            public void received(Packet packet) {
                taken.add(packet.type());
                throw new LinkageError("made up");
            }

            @Override
            public void ended(LinkLost cause) {
                ended.countDown();
            }
        });
        ended.await();

        assertThat(taken).containsExactly(0x32, 0x33);
    }
}
