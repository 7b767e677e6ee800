package majic.pioneer.line;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.argThat;
import static org.mockito.Mockito.doThrow;
import static org.mockito.Mockito.inOrder;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.timeout;
import static org.mockito.Mockito.verify;

import majic.driver.ReplayLink;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.state.Limits;
import majic.pioneer.state.Models;
import majic.pioneer.state.Ramps;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.Test;
import org.mockito.InOrder;

class ArcosLineTest {

    @Test
    void everyPacketIsOneWrite() {
        RecordingLink link = new RecordingLink();
        ArcosLine line = new ArcosLine(link, TimeSource.system(), mock());

        line.send(Ramps.careful(Limits.of(Models.USUAL, null)).packets());
        line.sendIfPossible(ArcosCommand.VEL.packet(0), ArcosCommand.RVEL.packet(0));

        assertThat(link.written).hasSize(8).allSatisfy(write -> {
            assertThat(write).startsWith(0xFA, 0xFB).hasSize((write[2] & 0xFF) + 3);
            assertThat(Bytes.packets(Bytes.hex(write))).hasSize(1);
        });
    }

    @Test
    void anErrorOverOnePacketLeavesTheLineToTheNextOnes() {
        ArcosLine.Listener listener = mock();
        doThrow(new LinkageError("made up")).when(listener).received(any());
        ReplayLink link = new ReplayLink(Bytes.wire(0x32, new byte[1]), Bytes.wire(0x33, new byte[1]));

        new ArcosLine(link, TimeSource.system(), listener).open();

        verify(listener, timeout(WaitLimit.MS)).ended(any());
        InOrder order = inOrder(listener);
        order.verify(listener).received(argThat(packet -> packet.type() == 0x32));
        order.verify(listener).received(argThat(packet -> packet.type() == 0x33));
        order.verify(listener).ended(any());
        order.verifyNoMoreInteractions();
    }
}
