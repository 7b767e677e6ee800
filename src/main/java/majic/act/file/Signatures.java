package majic.act.file;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.security.CodeSigner;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.jar.JarEntry;
import java.util.jar.JarInputStream;
import java.util.jar.Manifest;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Checks the signatures of a jar signed with jarsigner, and computes hashes. */
final class Signatures {
    private static final Pattern SIGNATURE = Pattern.compile("META-INF/[^/]+\\.(SF|RSA|DSA|EC)");

    private @Nullable Set<CodeSigner> signers;

    private Signatures() {}

    /**
     * Returns the signers of a whole jar.
     *
     * @param jar the jar
     * @param paths the paths of its entries
     * @param manifest its manifest
     * @return the signers; empty if it is not signed
     * @throws InvalidActException if a signature does not match the jar, or covers only a part of it
     */
    static List<Signer> check(byte[] jar, Set<String> paths, Manifest manifest) throws IOException {
        if (paths.stream().noneMatch(Signatures::isSignature)) {
            return List.of();
        }
        if (!paths.containsAll(manifest.getEntries().keySet())) {
            throw new InvalidActException("has a broken signature: something that was signed is missing");
        }
        try {
            return new Signatures().readAll(jar);
        } catch (SecurityException e) {
            throw new InvalidActException("has a broken signature: it was changed after it was signed", e);
        }
    }

    /** Returns the hash that identifies a file or certificate, 64 hexadecimal digits. */
    static String sha256(byte[] bytes) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    private static boolean isSignature(String path) {
        return SIGNATURE.matcher(path.toUpperCase(Locale.ROOT)).matches();
    }

    private List<Signer> readAll(byte[] jar) throws IOException {
        try (JarInputStream in = new JarInputStream(new ByteArrayInputStream(jar), true)) {
            for (JarEntry entry = in.getNextJarEntry(); entry != null; entry = in.getNextJarEntry()) {
                in.transferTo(OutputStream.nullOutputStream());
                in.closeEntry();
                if (!entry.isDirectory() && !entry.getName().startsWith("META-INF/")) {
                    take(entry);
                }
            }
        }
        return signers == null ? List.of() : signers.stream().map(Signer::of).toList();
    }

    private void take(JarEntry entry) throws InvalidActException {
        CodeSigner[] here = entry.getCodeSigners();
        if (here == null) {
            throw new InvalidActException("has a broken signature: " + entry.getName()
                    + " is not signed, or in a way that this Java does not accept");
        }
        Set<CodeSigner> common = new LinkedHashSet<>(Arrays.asList(here));
        if (signers != null) {
            common.retainAll(signers);
        }
        if (common.isEmpty()) {
            throw new InvalidActException("has a broken signature: no signature covers all of it");
        }
        signers = common;
    }
}
