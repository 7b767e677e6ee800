package majicsim.ros.message;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.SerializableString;
import com.fasterxml.jackson.core.io.CharacterEscapes;
import com.fasterxml.jackson.core.io.SerializedString;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.core.json.JsonWriteFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import org.jspecify.annotations.Nullable;

/**
 * How JSON text is read and written by one version: ROS 1 writes a slash as {@code \/}; both write characters beyond
 * ASCII as numbers, and read NaN and Infinity.
 */
public final class JsonForm {
    private final ObjectMapper reader = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .build();
    private final JsonFactory writer;

    /**
     * The form of a version.
     *
     * @param version decides about the slash
     */
    public JsonForm(RosVersion version) {
        writer = JsonFactory.builder()
                .disable(JsonWriteFeature.WRITE_NAN_AS_STRINGS)
                .enable(JsonWriteFeature.ESCAPE_NON_ASCII)
                .build();
        if (version == RosVersion.ROS1) {
            writer.setCharacterEscapes(new SlashEscape());
        }
    }

    /**
     * The reader of received text.
     *
     * @return the same at every call
     */
    public ObjectMapper reader() {
        return reader;
    }

    /**
     * Writes JSON.
     *
     * @param content what is written
     * @return UTF-8
     */
    public byte[] bytes(Content content) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JsonGenerator to = writer.createGenerator(bytes)) {
            to.setCodec(reader);
            content.write(to);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write to memory", e);
        }
        return bytes.toByteArray();
    }

    /** Something that writes itself. */
    public interface Content {
        /**
         * Writes one value.
         *
         * @param to where to
         * @throws IOException if the output fails
         */
        void write(JsonGenerator to) throws IOException;
    }

    private static final class SlashEscape extends CharacterEscapes {
        private static final long serialVersionUID = 1;

        private static final SerializableString ESCAPED = new SerializedString("\\/");

        @Override
        public int[] getEscapeCodesForAscii() {
            int[] codes = CharacterEscapes.standardAsciiEscapesForJSON();
            codes['/'] = CharacterEscapes.ESCAPE_CUSTOM;
            return codes;
        }

        @Override
        public @Nullable SerializableString getEscapeSequence(int character) {
            return character == '/' ? ESCAPED : null;
        }
    }
}
