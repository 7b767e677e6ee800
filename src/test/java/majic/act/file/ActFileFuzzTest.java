package majic.act.file;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.jar.Manifest;
import majic.act.ActException;
import majic.script.ScriptAct;
import majic.text.OneSentence;
import majic.text.VisibleText;

/** Arbitrary files of acts: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md). */
class ActFileFuzzTest {
    private static final String LABEL = "odd.act";
    private static final byte[] SCRIPT = saved(new ScriptAct("a.majic", "me move 100\n"));

    @FuzzTest
    void anyFileIsReadOrRefusedInOneSentence(byte[] file) {
        readOrRefused(file);
    }

    @FuzzTest
    void anyManifestIsReadOrRefusedInOneSentence(byte[] manifest) throws IOException {
        readOrRefused(BoundedZipTest.zip(Map.of(ActManifest.PATH, manifest, ActContents.DATA, SCRIPT)));
    }

    @FuzzTest
    void aManifestIsWrittenAsItWasRead(byte[] bytes) throws IOException {
        ActManifest manifest;
        try {
            manifest = ActManifest.of(ActManifest.parse(bytes));
        } catch (InvalidActException | IllegalArgumentException e) {
            return;
        }

        Manifest written = ActManifest.parse(manifest.bytes());

        assertThat(ActManifest.of(written)).isEqualTo(manifest);
    }

    @FuzzTest
    void anyClassFileIsReadOrRefusedInOneSentence(byte[] code) throws IOException {
        try {
            ClassFile read = ClassFile.parse(code);
            assertThat(read.uses()).doesNotContainNull();
        } catch (InvalidActException e) {
            OneSentence.check(e.getMessage());
        }
    }

    private static void readOrRefused(byte[] file) {
        try {
            ActFile read = ActFile.of(LABEL, file);
            assertThat(read.roles()).isNotEmpty();
            assertThat(read.describe()).allMatch(line -> line.equals(VisibleText.of(line)));
        } catch (ActException e) {
            assertThat(e).hasMessageStartingWith(LABEL + " ");
            OneSentence.check(e.getMessage());
        }
    }

    private static byte[] saved(Object object) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(object);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
