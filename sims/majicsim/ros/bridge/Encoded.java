package majicsim.ros.bridge;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.dataformat.cbor.CBORFactory;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import majicsim.ros.graph.Topic;
import majicsim.ros.message.JsonForm;
import majicsim.ros.message.MessageOutput;
import org.jspecify.annotations.Nullable;

/** One published message in the forms that clients asked for, each made once. */
final class Encoded {
    private static final CBORFactory CBOR = new CBORFactory();

    private final Topic topic;
    private final String name;
    private final JsonNode message;
    private final MessageOutput output;
    private final JsonForm form;
    private byte @Nullable [] text;
    private byte @Nullable [] cbor;

    Encoded(Topic topic, String name, JsonNode message, MessageOutput output, JsonForm form) {
        this.topic = topic;
        this.name = name;
        this.message = message;
        this.output = output;
        this.form = form;
    }

    void sendTo(Peer peer, String compression) {
        switch (compression) {
            case "cbor" -> sendCbor(peer);
            case "png" -> peer.send(null, new PngForm(text())::write);
            default -> peer.send(null, to -> to.writeRaw(new String(text(), java.nio.charset.StandardCharsets.UTF_8)));
        }
    }

    /** Where the conversion fails, the server sends nothing, and reports it nowhere but in its own log. */
    private void sendCbor(Peer peer) {
        if (output.hasCbor(topic.type(), message)) {
            peer.sendBinary(cbor());
        }
    }

    byte[] text() {
        if (text == null) {
            text = form.bytes(this::write);
        }
        return text;
    }

    private byte[] cbor() {
        if (cbor == null) {
            cbor = written();
        }
        return cbor;
    }

    private byte[] written() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JsonGenerator to = CBOR.createGenerator(bytes)) {
            write(to);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write to memory", e);
        }
        return bytes.toByteArray();
    }

    private void write(JsonGenerator to) throws IOException {
        to.writeStartObject();
        to.writeStringField("op", "publish");
        to.writeStringField("topic", name);
        to.writeFieldName("msg");
        output.write(to, topic.type(), message);
        to.writeEndObject();
    }
}
