package majic.tool;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.util.ArrayList;
import java.util.List;

/** Keys with certificates as a test needs them, made by {@code keytool} of the Java in use. */
public final class KeyTool {
    private KeyTool() {}

    /**
     * Makes a key store (PKCS 12) with one key and its own certificate for this name.
     *
     * @param options further ones of {@code keytool -genkeypair}, as {@code -startdate -20d}
     */
    public static KeyStore make(Path file, String password, String alias, String name, String... options)
            throws IOException, InterruptedException, GeneralSecurityException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "keytool").toString(), "-J-XX:TieredStopAtLevel=1"));
        command.addAll(List.of("-genkeypair", "-keyalg", "EC"));
        command.addAll(List.of("-alias", alias, "-dname", name, "-storetype", "PKCS12"));
        command.addAll(List.of("-keystore", file.toString(), "-storepass", password));
        command.addAll(List.of(options));
        String printed = Tool.run(command.toArray(String[]::new));
        assertThat(file).as(printed).exists();
        return KeyStore.getInstance(file.toFile(), password.toCharArray());
    }
}
