package majic.shared.broker;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufUtil;
import java.nio.charset.StandardCharsets;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * Checks a packet PUBLISH by the rules of MQTT 5 (OASIS standard, sections 1.5.4 and 3.3) for which the client library
 * ends the connection.
 */
final class PublishCheck {
    private static final int LONGEST_SHOWN = 60;
    private static final int PAYLOAD_FORMAT_INDICATOR = 0x01;
    private static final int MESSAGE_EXPIRY_INTERVAL = 0x02;
    private static final int CONTENT_TYPE = 0x03;
    private static final int RESPONSE_TOPIC = 0x08;
    private static final int CORRELATION_DATA = 0x09;
    private static final int SUBSCRIPTION_IDENTIFIER = 0x0B;
    private static final int TOPIC_ALIAS = 0x23;
    private static final int USER_PROPERTY = 0x26;

    private final ByteBuf body;
    private long seen;

    /** What is wrong in the packet. */
    private static final class Malformed extends Exception {
        private static final long serialVersionUID = 1;

        Malformed(String problem) {
            super(problem, null, false, false);
        }
    }

    private PublishCheck(ByteBuf body) {
        this.body = body;
    }

    /**
     * Returns what is wrong.
     *
     * @param body the packet behind its fixed header; its reader index is left anywhere
     * @param quality of service, 0 to 2
     * @return half a sentence; null if nothing is wrong
     */
    static @Nullable String problem(ByteBuf body, int quality) {
        try {
            new PublishCheck(body).check(quality);
            return null;
        } catch (Malformed e) {
            return e.getMessage();
        } catch (IndexOutOfBoundsException e) {
            return "it ends too early";
        }
    }

    private void check(int quality) throws Malformed {
        topic("its topic", true);
        body.skipBytes(quality == 0 ? 0 : Short.BYTES);
        int length = variableInteger("the length of its properties");
        int end = body.readerIndex() + length;
        while (body.readerIndex() < end) {
            property(body.readUnsignedByte());
        }
        if (body.readerIndex() > end || end > body.writerIndex()) {
            throw new Malformed("the length of its properties is wrong");
        }
    }

    private void property(int identifier) throws Malformed {
        if (identifier != USER_PROPERTY && identifier != SUBSCRIPTION_IDENTIFIER) {
            once(identifier);
        }
        switch (identifier) {
            case PAYLOAD_FORMAT_INDICATOR -> payloadFormat(body.readUnsignedByte());
            case MESSAGE_EXPIRY_INTERVAL -> body.skipBytes(Integer.BYTES);
            case CONTENT_TYPE -> text("its content type");
            case RESPONSE_TOPIC -> topic("its response topic", false);
            case CORRELATION_DATA -> body.skipBytes(body.readUnsignedShort());
            case SUBSCRIPTION_IDENTIFIER -> variableInteger("its subscription identifier");
            case TOPIC_ALIAS -> body.skipBytes(Short.BYTES);
            case USER_PROPERTY -> {
                text("a user property");
                text("a user property");
            }
            default -> throw new Malformed("it has a property that does not exist (" + identifier + ")");
        }
    }

    private void once(int identifier) throws Malformed {
        long bit = 1L << (identifier & 0x3F);
        if ((seen & bit) != 0) {
            throw new Malformed("it has a property twice (" + identifier + ")");
        }
        seen |= bit;
    }

    private static void payloadFormat(int indicator) throws Malformed {
        if (indicator > 1) {
            throw new Malformed("its payload format indicator is " + indicator + " instead of 0 or 1");
        }
    }

    /** A topic alias replaces the topic itself. */
    private void topic(String what, boolean mayBeEmpty) throws Malformed {
        String topic = text(what);
        if (topic.isEmpty() && !mayBeEmpty) {
            throw new Malformed(what + " is empty");
        }
        if (topic.indexOf('+') >= 0 || topic.indexOf('#') >= 0) {
            throw new Malformed(what + " \"" + shown(topic) + "\" contains a wildcard");
        }
    }

    private String text(String what) throws Malformed {
        int length = body.readUnsignedShort();
        if (!ByteBufUtil.isText(body, body.readerIndex(), length, StandardCharsets.UTF_8)) {
            throw new Malformed(what + " is not UTF-8");
        }
        String text = body.readCharSequence(length, StandardCharsets.UTF_8).toString();
        if (text.indexOf('\0') >= 0) {
            throw new Malformed(what + " contains the character U+0000");
        }
        return text;
    }

    private int variableInteger(String what) throws Malformed {
        int value = 0;
        for (int shift = 0; shift < 4 * 7; shift += 7) {
            int next = body.readUnsignedByte();
            value |= (next & 0x7F) << shift;
            if (next < 0x80) {
                return value;
            }
        }
        throw new Malformed(what + " is wrong");
    }

    /**
     * Returns the topic of a packet.
     *
     * @param body the packet behind its fixed header; its reader index is left at the end of the topic
     * @return with control characters made visible
     */
    static String topic(ByteBuf body) {
        int length = Math.min(body.readUnsignedShort(), body.readableBytes());
        return VisibleText.of(
                body.readCharSequence(length, StandardCharsets.UTF_8).toString());
    }

    private static String shown(String text) {
        return VisibleText.beginning(VisibleText.of(text), LONGEST_SHOWN);
    }
}
