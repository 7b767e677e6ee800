package majic.shared.broker;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.Key;
import java.security.KeyStore;
import java.util.Base64;
import majic.server.ListenKey;

/** The key of a folder in the format that Mosquitto reads. */
final class PemKey {
    private PemKey() {}

    /** Writes the key beside the key store of the folder; returns the file. */
    static Path write(Path folder) throws IOException, GeneralSecurityException {
        KeyStore store = KeyStore.getInstance("PKCS12");
        try (InputStream in = Files.newInputStream(folder.resolve(ListenKey.FILE))) {
            store.load(in, ListenKey.PASSWORD.toCharArray());
        }
        Key key = store.getKey(store.aliases().nextElement(), ListenKey.PASSWORD.toCharArray());
        String text = Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(key.getEncoded());
        return Files.writeString(
                folder.resolve("key.pem"), "-----BEGIN PRIVATE KEY-----\n" + text + "\n-----END PRIVATE KEY-----\n");
    }
}
