package majicsim.ros.message;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.dataformat.cbor.CBORFactory;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;

/** The same structures as CBOR. */
public final class CborForm {
    private static final CBORFactory FACTORY = new CBORFactory();

    private CborForm() {}

    /**
     * Writes CBOR.
     *
     * @param content what is written
     * @return the bytes of one value
     */
    public static byte[] bytes(JsonForm.Content content) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JsonGenerator to = FACTORY.createGenerator(bytes)) {
            content.write(to);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write to memory", e);
        }
        return bytes.toByteArray();
    }
}
