package majic.shared.broker;

import com.hivemq.client.mqtt.MqttClientSslConfig;
import com.hivemq.client.mqtt.MqttClientSslConfigBuilder;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.util.ArrayList;
import java.util.List;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLPeerUnverifiedException;
import javax.net.ssl.SSLSession;
import javax.net.ssl.TrustManagerFactory;
import majic.bot.BotException;
import majic.text.IoReason;

/**
 * TLS as the client library takes it: the certificates that are trusted and shown. Names are checked as for HTTPS,
 * unless the file names certificates of brokers themselves and not of authorities: then the broker has to show one of
 * these.
 */
final class HiveTls {
    private HiveTls() {}

    /**
     * Makes the configuration for a broker.
     *
     * @throws BotException if a file cannot be read; the message names it
     */
    static MqttClientSslConfig config(BrokerCredentials credentials) {
        MqttClientSslConfigBuilder config = MqttClientSslConfig.builder();
        Path authority = credentials.authority();
        if (authority != null) {
            List<X509Certificate> trusted =
                    reading(authority, "a file with certificates (PEM)", in -> certificates(in));
            config = config.trustManagerFactory(trust(trusted));
            if (trusted.stream().allMatch(one -> one.getBasicConstraints() < 0)) {
                config = config.hostnameVerifier((host, session) -> shows(session, trusted));
            }
        }
        Path keyStore = credentials.keyStore();
        if (keyStore != null) {
            char[] password = credentials.keyStorePassword().toCharArray();
            config = config.keyManagerFactory(
                    reading(keyStore, "a key store (PKCS 12) with this password", in -> keys(in, password)));
        }
        return config.build();
    }

    /** Makes something of a file. */
    private interface Reading<T> {
        T of(InputStream in) throws IOException, GeneralSecurityException;
    }

    private static <T> T reading(Path file, String expected, Reading<T> reading) {
        try (InputStream in = Files.newInputStream(file)) {
            return reading.of(in);
        } catch (IOException e) {
            throw unreadable(file, expected, IoReason.of(e), e);
        } catch (GeneralSecurityException e) {
            throw unreadable(file, expected, String.valueOf(e.getMessage()), e);
        }
    }

    private static BotException unreadable(Path file, String expected, String reason, Exception cause) {
        return new BotException(
                file + ", named in " + CredentialsFile.NAME + ", cannot be read as " + expected + ": " + reason
                        + "; is the entry right?",
                cause);
    }

    private static List<X509Certificate> certificates(InputStream in) throws IOException, GeneralSecurityException {
        List<X509Certificate> all = new ArrayList<>();
        for (Certificate one : CertificateFactory.getInstance("X.509").generateCertificates(in)) {
            all.add((X509Certificate) one);
        }
        if (all.isEmpty()) {
            throw new IOException("there is no certificate in it");
        }
        return all;
    }

    private static TrustManagerFactory trust(List<X509Certificate> certificates) {
        try {
            KeyStore trusted = KeyStore.getInstance(KeyStore.getDefaultType());
            trusted.load(null, null);
            for (X509Certificate one : certificates) {
                trusted.setCertificateEntry("trusted" + trusted.size(), one);
            }
            TrustManagerFactory factory = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
            factory.init(trusted);
            return factory;
        } catch (IOException | GeneralSecurityException e) {
            throw new BotException("this Java cannot use the certificates of a broker: " + e.getMessage(), e);
        }
    }

    private static boolean shows(SSLSession session, List<X509Certificate> expected) {
        try {
            Certificate[] shown = session.getPeerCertificates();
            return shown.length > 0 && expected.contains(shown[0]);
        } catch (SSLPeerUnverifiedException e) {
            return false;
        }
    }

    private static KeyManagerFactory keys(InputStream in, char[] password)
            throws IOException, GeneralSecurityException {
        KeyStore own = KeyStore.getInstance("PKCS12");
        own.load(in, password);
        KeyManagerFactory factory = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
        factory.init(own, password);
        return factory;
    }
}
