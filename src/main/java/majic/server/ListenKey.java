package majic.server;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.security.cert.CertificateException;
import java.security.cert.CertificateExpiredException;
import java.security.cert.CertificateNotYetValidException;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.Base64;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;

/**
 * The key with which MAJIC proves to programs on other computers that it is the right one: a key store that only its
 * user can read, and beside it the certificate, which these programs get.
 *
 * @param file the key store
 * @param certificate what programs on other computers accept
 * @param context encrypts connections with the key
 */
public record ListenKey(Path file, X509Certificate certificate, SSLContext context) {
    /** The file of the key store, in MAJIC's folder. */
    public static final String FILE = "listen.p12";

    /** The file of the certificate, in MAJIC's folder. */
    public static final String CERTIFICATE = "listen.pem";

    /** The format requires a password; what protects the key is that only its user can read the file. */
    public static final String PASSWORD = "majic-listen";

    private static final String PASSWORD_VARIABLE = "MAJIC_KEY_STORE_PASSWORD";
    private static final String ALIAS = "majic";
    private static final String FORMAT = "PKCS12";
    private static final Duration WARNED_BEFORE = Duration.ofDays(30);
    private static final int BASE64_LINE = 64;

    /**
     * Makes a key and a certificate for it, by {@code keytool} of the Java in use.
     *
     * @param folder the folder of both files
     * @throws IOException if there is a key already, or the files cannot be written; the message is for users
     */
    public static void create(Path folder) throws IOException {
        Path file = folder.resolve(FILE);
        if (Files.exists(file)) {
            throw new IOException(file + " exists, and other computers may trust it; delete it to make a new key");
        }
        Files.createDirectories(folder);
        Path temporary = Files.createTempDirectory("majic-key");
        Path made = temporary.resolve(FILE);
        try {
            runKeytool(made);
            byte[] store = Files.readAllBytes(made);
            OwnerOnlyFile.write(file, store);
            Files.writeString(folder.resolve(CERTIFICATE), pem(certificate(read(file))));
        } catch (GeneralSecurityException e) {
            throw new IOException("keytool made a key that cannot be used: " + e.getMessage(), e);
        } finally {
            Files.deleteIfExists(made);
            Files.delete(temporary);
        }
    }

    private static void runKeytool(Path file) throws IOException {
        Path keytool = Path.of(System.getProperty("java.home"), "bin", "keytool");
        ProcessBuilder builder = new ProcessBuilder(Stream.of(
                        List.of(keytool.toString(), "-J-XX:TieredStopAtLevel=1"),
                        List.of("-genkeypair", "-alias", ALIAS, "-dname", "CN=MAJIC"),
                        List.of("-keyalg", "EC", "-groupname", "secp256r1", "-validity", "3650"),
                        List.of("-storetype", FORMAT, "-keystore", file.toString()),
                        List.of("-storepass:env", PASSWORD_VARIABLE))
                .flatMap(List::stream)
                .toList());
        builder.environment().putAll(Map.of(PASSWORD_VARIABLE, PASSWORD));
        Process process = builder.redirectErrorStream(true).start();
        String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        try {
            if (process.waitFor() != 0) {
                throw new IOException("keytool failed: " + printed.strip());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", e);
        }
    }

    /**
     * Reads the key.
     *
     * @param folder MAJIC's folder
     * @return the key
     * @throws IOException if there is none, it cannot be read, or its certificate has expired; the message is for users
     */
    public static ListenKey in(Path folder) throws IOException {
        Path file = folder.resolve(FILE);
        if (!Files.exists(file)) {
            throw new IOException("other computers need TLS, and there is no key for it: \"majic key\" makes " + file
                    + "; programs on this computer need none at 127.0.0.1");
        }
        try {
            ListenKey key = unchecked(file);
            key.certificate.checkValidity();
            return key;
        } catch (CertificateExpiredException e) {
            throw new IOException(
                    file + ": its certificate has expired; delete the file, and \"majic key\" makes a new one", e);
        } catch (CertificateNotYetValidException e) {
            throw new IOException(file + ": its certificate is not valid yet; set the clock of this computer right", e);
        } catch (GeneralSecurityException e) {
            throw new IOException(file + ": " + e.getMessage() + "; delete it, and \"majic key\" makes a new one", e);
        }
    }

    /** Reads a key whose certificate may have expired. */
    static ListenKey unchecked(Path file) throws IOException, GeneralSecurityException {
        KeyStore store = read(file);
        KeyManagerFactory keys = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
        keys.init(store, PASSWORD.toCharArray());
        SSLContext context = SSLContext.getInstance("TLSv1.3");
        context.init(keys.getKeyManagers(), null, null);
        return new ListenKey(file, certificate(store), context);
    }

    /**
     * Returns a warning about the age of the certificate: a program that checks it refuses the connection once it has
     * expired.
     *
     * @param now the time to compare with
     * @return a sentence if it has expired or will in 30 days; empty otherwise
     */
    Optional<String> warning(Instant now) {
        Instant end = certificate.getNotAfter().toInstant();
        if (now.plus(WARNED_BEFORE).isBefore(end)) {
            return Optional.empty();
        }
        String date = LocalDate.ofInstant(end, ZoneId.systemDefault()).toString();
        return Optional.of("the certificate of --listen " + (now.isAfter(end) ? "expired on " : "expires on ") + date
                + ", and programs on other computers refuse it then; delete " + file
                + ", run \"majic key\", start MAJIC again, and copy " + CERTIFICATE + " to these computers");
    }

    private static KeyStore read(Path file) throws IOException, GeneralSecurityException {
        KeyStore store = KeyStore.getInstance(FORMAT);
        try (InputStream in = Files.newInputStream(file)) {
            store.load(in, PASSWORD.toCharArray());
            return store;
        } catch (IOException e) {
            throw new IOException(
                    file + " is not a key store with MAJIC's password; delete it, and \"majic key\" makes a new one",
                    e);
        }
    }

    private static X509Certificate certificate(KeyStore store) throws GeneralSecurityException {
        for (String alias : Collections.list(store.aliases())) {
            if (store.isKeyEntry(alias) && store.getCertificate(alias) instanceof X509Certificate certificate) {
                return certificate;
            }
        }
        throw new CertificateException("it contains no key");
    }

    private static String pem(Certificate certificate) throws CertificateException {
        Base64.Encoder lines = Base64.getMimeEncoder(BASE64_LINE, new byte[] {'\n'});
        return "-----BEGIN CERTIFICATE-----\n" + lines.encodeToString(certificate.getEncoded())
                + "\n-----END CERTIFICATE-----\n";
    }
}
