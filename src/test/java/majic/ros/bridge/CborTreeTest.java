package majic.ros.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.dataformat.cbor.CBORFactory;
import com.fasterxml.jackson.dataformat.cbor.CBORGenerator;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Arrays of numbers in CBOR, which servers write as bytes with a tag. */
class CborTreeTest {
    private static JsonNode read(int tag, byte[] bytes) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (CBORGenerator to = new CBORFactory().createGenerator(out)) {
            to.writeStartObject();
            to.writeFieldName("data");
            if (tag != 0) {
                to.writeTag(tag);
            }
            to.writeBinary(bytes);
            to.writeStringField("name", "a");
            to.writeNumberField("big", 9_007_199_254_740_993L);
            to.writeEndObject();
        }
        JsonNode message = BridgeCodec.decode(out.toByteArray());
        assertThat(message.path("name").asText()).isEqualTo("a");
        assertThat(message.path("big").asLong()).isEqualTo(9_007_199_254_740_993L);
        return message.path("data");
    }

    @ParameterizedTest(name = "tag {0}")
    @CsvSource({
        "69, 65535",
        "70, 4294967295",
        "71, 18446744073709551615",
        "72, -1",
        "77, -1",
        "78, -1",
        "79, -1",
    })
    void wholeNumbersHaveTheirSign(int tag, String last) throws IOException {
        byte[] bytes = new byte[16];
        bytes[0] = 100;
        for (int i = 8; i < 16; i++) {
            bytes[i] = -1;
        }

        JsonNode numbers = read(tag, bytes);

        assertThat(numbers.isArray()).isTrue();
        assertThat(numbers.path(0).asInt()).isEqualTo(100);
        assertThat(numbers.path(numbers.size() - 1).asText()).isEqualTo(last);
    }

    @Test
    void numbersWithAPointMayBeInfinite() throws IOException {
        ByteBuffer floats = ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN);
        floats.putFloat(0.5f).putFloat(Float.POSITIVE_INFINITY);
        ByteBuffer doubles =
                ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN).putDouble(-0.1);

        assertThat(read(85, floats.array()).path(0).asDouble()).isEqualTo(0.5);
        assertThat(read(85, floats.array()).path(1).asDouble()).isInfinite();
        assertThat(read(86, doubles.array()).path(0).asDouble()).isEqualTo(-0.1);
    }

    @Test
    void bytesWithoutATagStayBytes() throws IOException {
        assertThat(read(0, new byte[] {1, 2, 3}).binaryValue()).containsExactly(1, 2, 3);
    }

    @Test
    void anIncompleteValueIsRefused() {
        assertThatThrownBy(() -> BridgeCodec.decode(new byte[] {(byte) 0xBF, 0x61}))
                .isInstanceOf(IOException.class);
        assertThatThrownBy(() -> BridgeCodec.decode(new byte[0])).isInstanceOf(IOException.class);
    }
}
