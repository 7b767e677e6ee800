package majic.shared.broker;

import com.hivemq.client.internal.mqtt.MqttClientConnectionConfig;
import com.hivemq.client.internal.mqtt.codec.decoder.MqttDecoder;
import com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient;
import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelPipeline;
import io.netty.handler.codec.ByteToMessageDecoder;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.function.BiConsumer;

/**
 * Leaves out messages that are malformed, before the client library reads them: it would end the connection, and again
 * each time the broker delivers such a message that it keeps. Any client of the broker can publish one, since brokers
 * do not check all properties. Acknowledges them, so that the broker goes on. Runs on the thread of the network.
 */
final class MalformedMessages extends ByteToMessageDecoder {
    private static final int PUBLISH = 3;
    private static final int PUBACK = 0x40;
    private static final int SMALLEST_HEADER = 2;
    private static final int LARGEST_HEADER = 5;

    private final BiConsumer<String, String> listener;
    private boolean passing;

    private MalformedMessages(BiConsumer<String, String> listener) {
        this.listener = listener;
    }

    /**
     * Checks everything that arrives at a client from now on. To be called before the client subscribes to anything.
     *
     * @param listener is called with the topic of each message that is left out, and with what is wrong in it
     */
    static void leaveOut(Mqtt5AsyncClient client, BiConsumer<String, String> listener) {
        client.getConfig()
                .getConnectionConfig()
                .filter(MqttClientConnectionConfig.class::isInstance)
                .map(connection ->
                        ((MqttClientConnectionConfig) connection).getChannel().pipeline())
                .ifPresent(pipeline -> insert(pipeline, new MalformedMessages(listener)));
    }

    private static void insert(ChannelPipeline pipeline, MalformedMessages check) {
        try {
            pipeline.addBefore(MqttDecoder.NAME, "malformed messages", check);
        } catch (NoSuchElementException e) {
            // The connection has ended meanwhile.
        }
    }

    @Override
    protected void decode(ChannelHandlerContext context, ByteBuf in, List<Object> out) {
        int header = passing ? 0 : headerLength(in);
        if (passing || header > LARGEST_HEADER) {
            // The length of a packet is wrong: the library ends the connection.
            passing = true;
            out.add(in.readRetainedSlice(in.readableBytes()));
            return;
        }
        int length = header == 0 ? Integer.MAX_VALUE : header + bodyLength(in, header);
        if (in.readableBytes() >= length) {
            decode(context, in.readSlice(length), header, out);
        }
    }

    /** Returns the length of the fixed header; 0 if it has not arrived, more than the largest if it is wrong. */
    private static int headerLength(ByteBuf in) {
        for (int length = SMALLEST_HEADER; length <= in.readableBytes(); length++) {
            if (length > LARGEST_HEADER || in.getByte(in.readerIndex() + length - 1) >= 0) {
                return length;
            }
        }
        return 0;
    }

    private static int bodyLength(ByteBuf in, int header) {
        int length = 0;
        for (int at = 1; at < header; at++) {
            length |= (in.getByte(in.readerIndex() + at) & 0x7F) << 7 * (at - 1);
        }
        return length;
    }

    private void decode(ChannelHandlerContext context, ByteBuf packet, int header, List<Object> out) {
        int first = packet.getUnsignedByte(packet.readerIndex());
        int quality = first >> 1 & 3;
        ByteBuf body = packet.slice(packet.readerIndex() + header, packet.readableBytes() - header);
        String problem = first >> 4 == PUBLISH && quality < 2 ? PublishCheck.problem(body.duplicate(), quality) : null;
        if (problem == null) {
            out.add(packet.retain());
        } else {
            leaveOut(context, body, quality, problem);
        }
    }

    private void leaveOut(ChannelHandlerContext context, ByteBuf body, int quality, String problem) {
        String topic = body.readableBytes() < Short.BYTES ? "" : PublishCheck.topic(body);
        if (quality == 1 && body.readableBytes() >= Short.BYTES) {
            context.writeAndFlush(context.alloc()
                    .buffer(4)
                    .writeByte(PUBACK)
                    .writeByte(Short.BYTES)
                    .writeShort(body.readUnsignedShort()));
        }
        listener.accept(topic, problem);
    }
}
