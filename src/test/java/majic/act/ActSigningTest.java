package majic.act;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.ZipFile;
import jdk.security.jarsigner.JarSigner;
import majic.act.file.ActFile;
import majic.act.file.ActManifest;
import majic.act.file.BoundedZip;
import majic.act.file.BoundedZipTest;
import majic.tool.KeyTool;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that a signed file names its signer, and is refused after any change. */
@Tag("jdk")
class ActSigningTest {
    private static final char[] PASSWORD = "correct horse".toCharArray();

    @TempDir
    static Path folder;

    private static byte[] signed;

    @BeforeAll
    static void sign() throws Exception {
        Path act = Files.write(folder.resolve("wander.act"), Sources.act(folder, "Wander", Sources.WANDER));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipFile jar = new ZipFile(act.toFile())) {
            new JarSigner.Builder(key()).signerName("ADA").build().sign(jar, bytes);
        }
        signed = bytes.toByteArray();
    }

    private static KeyStore.PrivateKeyEntry key() throws IOException, InterruptedException, GeneralSecurityException {
        KeyStore keys = KeyTool.make(folder.resolve("keys"), new String(PASSWORD), "ada", "CN=Ada Lovelace");
        return (KeyStore.PrivateKeyEntry) keys.getEntry("ada", new KeyStore.PasswordProtection(PASSWORD));
    }

    @Test
    void itsSignerIsShownAndItLoads() {
        ActFile file = ActFile.of("wander.act", signed);
        assertThat(file.signers()).singleElement().satisfies(signer -> {
            assertThat(signer.name()).isEqualTo("CN=Ada Lovelace");
            assertThat(signer.fingerprint()).matches("[0-9a-f]{64}");
        });
        assertThat(file.describe()).anyMatch(line -> line.startsWith("signed by: CN=Ada Lovelace (certificate "));
        assertThat(file.load(Sources.trusting(file)).getClass().getName()).isEqualTo("Wander");
    }

    @Test
    void aClassThatWasExchangedBreaksTheSignature() throws IOException {
        Map<String, byte[]> entries = entries();
        entries.put("Helper.class", TinyClass.of("Helper", 61));
        assertRefused(entries, "it was changed after it was signed");
    }

    @Test
    void anActThatWasExchangedBreaksTheSignature() throws IOException {
        Map<String, byte[]> entries = entries();
        entries.get("act.ser")[entries.get("act.ser").length - 1] ^= 1;
        assertRefused(entries, "it was changed after it was signed");
    }

    @Test
    void aClassThatWasAddedBreaksTheSignature() throws IOException {
        Map<String, byte[]> entries = entries();
        entries.put("Added.class", TinyClass.of("Added", 61));
        assertRefused(entries, "Added.class is not signed");
    }

    @Test
    void aClassThatWasTakenOutBreaksTheSignature() throws IOException {
        Map<String, byte[]> entries = entries();
        entries.remove("Helper.class");
        assertRefused(entries, "something that was signed is missing");
    }

    @Test
    void aManifestThatWasChangedBreaksTheSignature() throws IOException {
        Map<String, byte[]> entries = entries();
        String manifest = new String(entries.get(ActManifest.PATH), StandardCharsets.UTF_8);
        entries.put(
                ActManifest.PATH, manifest.replace("Act-Name: W", "Act-Name: V").getBytes(StandardCharsets.UTF_8));
        assertRefused(entries, "a broken signature");
    }

    @Test
    void aSignatureOfSomethingElseIsBroken() throws IOException {
        Map<String, byte[]> entries = entries();
        byte[] block = entries.get("META-INF/ADA.EC");
        block[block.length - 1] ^= 1;
        assertRefused(entries, "a broken signature");
    }

    private static Map<String, byte[]> entries() throws IOException {
        return new LinkedHashMap<>(BoundedZip.unpack(signed));
    }

    private static void assertRefused(Map<String, byte[]> entries, String why) {
        byte[] file = BoundedZipTest.zip(entries);
        assertThatThrownBy(() -> ActFile.of("bad.act", file))
                .isInstanceOf(ActException.class)
                .hasMessageContaining("bad.act has a broken signature")
                .hasMessageContaining(why);
    }
}
