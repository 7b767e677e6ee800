package majic.shared.broker;

import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5PublishBuilderBase;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5WillPublish;
import java.nio.ByteBuffer;

/** Messages from and to the classes of the client library. */
final class HiveMessages {
    private HiveMessages() {}

    static Mqtt5Publish publish(BrokerMessage message) {
        return fill(Mqtt5Publish.builder().topic(message.topic()), message).build();
    }

    static Mqtt5WillPublish will(BrokerMessage message) {
        return fill(Mqtt5WillPublish.builder().topic(message.topic()), message).build();
    }

    static MqttQos quality(Quality quality) {
        return switch (quality) {
            case AT_MOST_ONCE -> MqttQos.AT_MOST_ONCE;
            case AT_LEAST_ONCE -> MqttQos.AT_LEAST_ONCE;
        };
    }

    private static <B extends Mqtt5PublishBuilderBase.Complete<B>> B fill(B builder, BrokerMessage message) {
        B filled = builder.payload(message.payload())
                .qos(quality(message.quality()))
                .retain(message.retained())
                .correlationData(message.correlation())
                .responseTopic(message.responseTopic())
                .contentType(message.contentType().isEmpty() ? null : message.contentType());
        return message.expirySeconds() == 0 ? filled : filled.messageExpiryInterval(message.expirySeconds());
    }

    static BrokerMessage received(Mqtt5Publish publish) {
        return new BrokerMessage(
                publish.getTopic().toString(),
                publish.getPayloadAsBytes(),
                publish.getQos() == MqttQos.AT_MOST_ONCE ? Quality.AT_MOST_ONCE : Quality.AT_LEAST_ONCE,
                publish.isRetain(),
                publish.getResponseTopic().map(Object::toString).orElse(null),
                publish.getCorrelationData().map(HiveMessages::bytes).orElse(null),
                (int) Math.min(
                        Integer.MAX_VALUE, publish.getMessageExpiryInterval().orElse(0)),
                publish.getContentType().map(Object::toString).orElse(""));
    }

    private static byte[] bytes(ByteBuffer buffer) {
        byte[] bytes = new byte[buffer.remaining()];
        buffer.duplicate().get(bytes);
        return bytes;
    }
}
