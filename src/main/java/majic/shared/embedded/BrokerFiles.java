package majic.shared.embedded;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Stream;
import majic.bot.BotException;
import org.jspecify.annotations.Nullable;

/** The files of one run of the embedded broker, in a temporary folder that only this user can read. */
final class BrokerFiles implements AutoCloseable {
    private static final String QUIET = "<configuration>"
            + "<statusListener class=\"ch.qos.logback.core.status.NopStatusListener\"/>"
            + "<root level=\"OFF\"/></configuration>";

    private final Path folder;

    BrokerFiles(EmbeddedOptions options) {
        try {
            folder = Files.createTempDirectory("majic-broker");
            for (String name : new String[] {"conf", "data", "extensions", "log"}) {
                Files.createDirectory(folder.resolve(name));
            }
            Files.writeString(folder.resolve("log/logback.xml"), QUIET);
            Files.writeString(folder.resolve("conf/config.xml"), configuration(options));
        } catch (IOException e) {
            throw new BotException("the embedded broker cannot write its files: " + e.getMessage(), e);
        }
    }

    private static String configuration(EmbeddedOptions options) {
        Path keyStore = options.keyStore();
        String at = "<port>" + options.address().getPort() + "</port><bind-address>"
                + options.address().getAddress().getHostAddress() + "</bind-address>";
        return "<hivemq><listeners>"
                + (keyStore == null
                        ? "<tcp-listener>" + at + "</tcp-listener>"
                        : "<tls-tcp-listener>" + at + tls(keyStore, options.keyStorePassword()) + "</tls-tcp-listener>")
                + "</listeners><persistence><mode>in-memory</mode></persistence>"
                + "<anonymous-usage-statistics><enabled>false</enabled></anonymous-usage-statistics></hivemq>";
    }

    private static String tls(@Nullable Path keyStore, String password) {
        return "<tls><keystore><path>" + escaped(String.valueOf(keyStore)) + "</path><password>" + escaped(password)
                + "</password><private-key-password>" + escaped(password)
                + "</private-key-password></keystore></tls>";
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }

    Path part(String name) {
        return folder.resolve(name);
    }

    @Override
    public void close() {
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path one : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(one);
            }
        } catch (IOException | UncheckedIOException e) {
            System.getLogger(BrokerFiles.class.getName())
                    .log(System.Logger.Level.WARNING, "the files of the broker stay in " + folder, e);
        }
    }
}
