package majic.shared.embedded;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Optional;
import java.util.function.BiPredicate;
import org.jspecify.annotations.Nullable;

/** An extension of the embedded broker that accepts one user with one password. */
final class PasswordExtension {
    private static final String SDK = "com.hivemq.extension.sdk.api.";
    private static final String AUTH = SDK + "auth.";

    private final BrokerLibraries libraries;
    private final BiPredicate<String, byte[]> right;

    PasswordExtension(BrokerLibraries libraries, String user, String password) {
        this.libraries = libraries;
        byte[] expected = password.getBytes(StandardCharsets.UTF_8);
        right = (name, given) ->
                MessageDigest.isEqual(name.getBytes(StandardCharsets.UTF_8), user.getBytes(StandardCharsets.UTF_8))
                        & MessageDigest.isEqual(given, expected);
    }

    /** Returns the extension as the broker takes it. */
    @Nullable
    Object extension() {
        String type = "com.hivemq.embedded.EmbeddedExtension";
        String builder = "com.hivemq.embedded.EmbeddedExtensionBuilder";
        Object made = libraries.call(type, null, "builder");
        libraries.call(builder, made, "withId", "majic-password");
        libraries.call(builder, made, "withName", "MAJIC's password");
        libraries.call(builder, made, "withVersion", "1");
        libraries.call(builder, made, "withAuthor", "MAJIC");
        libraries.call(builder, made, "withPriority", 0);
        libraries.call(builder, made, "withStartPriority", 1000);
        libraries.call(builder, made, "withExtensionMain", libraries.implement(SDK + "ExtensionMain", this::main));
        return libraries.call(builder, made, "build");
    }

    private @Nullable Object main(String method, Object[] arguments) {
        if (method.equals("extensionStart")) {
            Object authenticator = libraries.implement(AUTH + "SimpleAuthenticator", this::authenticate);
            Object provider = libraries.implement(
                    SDK + "services.auth.provider.AuthenticatorProvider", (name, input) -> authenticator);
            Object registry = libraries.call(SDK + "services.Services", null, "securityRegistry");
            libraries.call(SDK + "services.auth.SecurityRegistry", registry, "setAuthenticatorProvider", provider);
        }
        return null;
    }

    private @Nullable Object authenticate(String method, Object[] arguments) {
        Object packet = libraries.call(AUTH + "parameter.SimpleAuthInput", arguments[0], "getConnectPacket");
        String connect = SDK + "packets.connect.ConnectPacket";
        Optional<?> user = (Optional<?>) libraries.call(connect, packet, "getUserName");
        Optional<?> password = (Optional<?>) libraries.call(connect, packet, "getPassword");
        boolean accepted = user != null
                && password != null
                && user.isPresent()
                && password.isPresent()
                && right.test((String) user.get(), bytes((ByteBuffer) password.get()));
        libraries.call(
                AUTH + "parameter.SimpleAuthOutput",
                arguments[1],
                accepted ? "authenticateSuccessfully" : "failAuthentication");
        return null;
    }

    private static byte[] bytes(ByteBuffer buffer) {
        byte[] bytes = new byte[buffer.remaining()];
        buffer.duplicate().get(bytes);
        return bytes;
    }
}
