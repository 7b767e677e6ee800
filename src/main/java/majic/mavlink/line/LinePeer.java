package majic.mavlink.line;

import java.net.InetSocketAddress;
import majic.mavlink.frame.MavlinkDecoder;
import majic.mavlink.frame.MavlinkEncoder;
import org.jspecify.annotations.Nullable;

/**
 * One end that frames come from: a vehicle, or a radio or proxy with several behind it.
 *
 * @param address where datagrams go to; null for the only other end of a stream
 * @param decoder of its bytes
 * @param encoder of what is sent to it
 */
record LinePeer(@Nullable InetSocketAddress address, MavlinkDecoder decoder, MavlinkEncoder encoder) {
    static LinePeer at(@Nullable InetSocketAddress address) {
        return new LinePeer(address, new MavlinkDecoder(), new MavlinkEncoder());
    }
}
