package majic.act.file;

import java.security.CodeSigner;
import java.security.cert.CertificateEncodingException;
import java.security.cert.X509Certificate;

/**
 * Identifies the signer of a file. The signature matches the file; whether the name is true can only be confirmed by
 * the certificate's owner.
 *
 * @param name the name in the certificate: {@code CN=Ada Lovelace, O=Analytical Engines}
 * @param fingerprint the SHA-256 of the certificate, 64 hexadecimal digits, to compare with the one that the signer
 *     gives
 */
public record Signer(String name, String fingerprint) {
    static Signer of(CodeSigner signer) {
        X509Certificate certificate =
                (X509Certificate) signer.getSignerCertPath().getCertificates().get(0);
        try {
            return new Signer(
                    certificate.getSubjectX500Principal().getName(), Signatures.sha256(certificate.getEncoded()));
        } catch (CertificateEncodingException e) {
            throw new IllegalStateException("a certificate that was read can be written", e);
        }
    }
}
