package majic.act.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that a jar is unpacked completely, or refused before it uses much memory or time. */
public class BoundedZipTest {
    private static final byte[] SOME = {1, 2, 3};

    public static byte[] zip(Map<String, byte[]> entries) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream out = new ZipOutputStream(bytes)) {
            for (Map.Entry<String, byte[]> one : entries.entrySet()) {
                out.putNextEntry(new ZipEntry(one.getKey()));
                out.write(one.getValue());
                out.closeEntry();
            }
        } catch (IOException e) {
            throw new AssertionError("memory takes what is written to it", e);
        }
        return bytes.toByteArray();
    }

    @Test
    void givesWhatLiesInItByPath() throws IOException {
        Map<String, byte[]> unpacked = BoundedZip.unpack(zip(Map.of("a/B.class", SOME, "folder/", new byte[0])));
        assertThat(unpacked).containsOnlyKeys("a/B.class");
        assertThat(unpacked.get("a/B.class")).isEqualTo(SOME);
    }

    @Test
    void oneEntryOfPackedZerosIsRefused() {
        byte[] bomb = zip(Map.of("zeros", new byte[64 << 20]));
        assertThat(bomb.length).isLessThan(1 << 20);
        assertThatThrownBy(() -> BoundedZip.unpack(bomb)).hasMessage("unpacks to more than any act needs, at zeros");
    }

    @Test
    void manyEntriesOfPackedZerosAreRefused() {
        Map<String, byte[]> many = new TreeMap<>();
        byte[] zeros = new byte[4 << 20];
        for (int i = 0; i < 10; i++) {
            many.put("zeros" + i, zeros);
        }
        byte[] bomb = zip(many);
        assertThatThrownBy(() -> BoundedZip.unpack(bomb)).hasMessageContaining("unpacks to more than any act needs");
    }

    @Test
    void thousandsOfEntriesAreRefused() {
        Map<String, byte[]> many = new TreeMap<>();
        for (int i = 0; i < 2_001; i++) {
            many.put("entry" + i, SOME);
        }
        byte[] crowd = zip(many);
        assertThatThrownBy(() -> BoundedZip.unpack(crowd)).hasMessage("has more than 2000 entries");
    }

    @ParameterizedTest
    @ValueSource(strings = {"../x.class", "a/../../x", "/etc/x", "..", "C:/x", "a\\..\\x", "C:x"})
    void anEntryThatPointsOutOfItIsRefused(String path) {
        byte[] jar = zip(Map.of(path, SOME));
        assertThatThrownBy(() -> BoundedZip.unpack(jar)).hasMessage("has an entry that points out of it: " + path);
    }

    @Test
    void twoEntriesOfOneNameAreRefused() {
        byte[] jar = zip(new TreeMap<>(Map.of("one", SOME, "two", SOME)));
        byte[] twins = replaced(jar, "two", "one");
        assertThatThrownBy(() -> BoundedZip.unpack(twins)).hasMessage("has two entries one");
    }

    @Test
    void whereverItEndsTooEarlyItIsRefused() {
        byte[] jar = zip(Map.of("a/B.class", SOME));
        for (int length = 0; length < jar.length; length++) {
            byte[] part = Arrays.copyOf(jar, length);
            assertThatThrownBy(() -> BoundedZip.unpack(part)).isInstanceOf(InvalidActException.class);
        }
    }

    @Test
    void anEntryThatNoListingShowsIsRefused() {
        byte[] jar = zip(Map.of("shown", SOME));
        byte[] hidden = zip(Map.of("hidden", SOME));
        int listAt = hidden.length - 22 - 46 - "hidden".length();
        byte[] both = Arrays.copyOf(hidden, listAt + jar.length);
        System.arraycopy(jar, 0, both, listAt, jar.length);
        assertThatThrownBy(() -> BoundedZip.unpack(both)).hasMessageContaining("its list of entries does not fit");
    }

    private static byte[] replaced(byte[] bytes, String from, String to) {
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        return text.replace(from, to).getBytes(StandardCharsets.ISO_8859_1);
    }
}
