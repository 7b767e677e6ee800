package majic.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.timeout;
import static org.mockito.Mockito.verify;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.Loopback;
import majic.bot.BotListener;
import majic.bot.BotType;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.Settings;
import majic.team.BotFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests robot types in jars in the plug-ins folder. */
@Tag("jdk")
class PluginsTest {
    @TempDir
    private Path folder;

    @Test
    void withoutPluginsThereAreTheThreeRobotsOfTheThesis() {
        assertThat(Plugins.in(folder.resolve("none")).types())
                .extracting(BotType::name)
                .containsExactly("aibo", "pioneer", "hemisson");
    }

    @Test
    void aJarInTheFolderBringsAnotherTypeAndItsRobotMoves() throws IOException {
        turtle("turtle.jar");
        BotFactory factory = new BotFactory(Plugins.in(folder).types(), Settings.inMemory());

        try (MajicBot turtle = factory.create("turtle://here")) {
            turtle.connect();

            assertThat(turtle.move(10).amount()).hasToString("about 10 mm");
            turtle.set("pen", "on");
            assertThat(turtle.get("pen")).hasToString("on");
        }
    }

    @Test
    void aPluginReadsItsRobotByTheReaderOfTheLibraryAndReportsTheLossOfTheLink() throws Exception {
        PluginJar.of("Cart$Type").with("Cart", "Cart$Type", "Cart$Reports").write(folder.resolve("cart.jar"));
        BotFactory factory = new BotFactory(Plugins.in(folder).types(), Settings.inMemory());
        try (ServerSocket server = Loopback.listen();
                MajicBot cart = factory.create("cart://127.0.0.1:" + server.getLocalPort())) {
            BotListener listener = mock();
            cart.addListener(listener);
            CompletableFuture<List<String>> received = CompletableFuture.supplyAsync(() -> drivenCart(server));
            cart.connect();

            assertThat(cart.move(100).amount()).hasToString("104 mm");
            assertThat(received.get()).containsExactly("drive 100 0", "drive 0 0");
            verify(listener, timeout(10_000)).connectionChanged(cart, MajicBot.Connection.LOST);
            assertThatThrownBy(() -> cart.move(100))
                    .isInstanceOf(LinkLost.class)
                    .hasMessageContaining("the cart closed it");
        }
    }

    @Test
    void aTurnByZeroDegreesOfTheExampleCartIsDone() throws Exception {
        PluginJar.of("Cart$Type").with("Cart", "Cart$Type", "Cart$Reports").write(folder.resolve("cart.jar"));
        BotFactory factory = new BotFactory(Plugins.in(folder).types(), Settings.inMemory());
        try (ServerSocket server = Loopback.listen();
                MajicBot cart = factory.create("cart://127.0.0.1:" + server.getLocalPort())) {
            cart.connect();

            assertThat(cart.turn(0).amount()).hasToString("about 0 deg");
        }
    }

    /** Reports two positions, with an unreadable line between them, and closes the link after the stop. */
    private static List<String> drivenCart(ServerSocket server) {
        try (Socket link = server.accept();
                BufferedReader commands =
                        new BufferedReader(new InputStreamReader(link.getInputStream(), StandardCharsets.US_ASCII))) {
            String drive = commands.readLine();
            link.getOutputStream()
                    .write("at 51 0 0\nat an unknown place\nat 104 0 0\n".getBytes(StandardCharsets.US_ASCII));
            return List.of(drive, commands.readLine());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void turtle(String file) throws IOException {
        PluginJar.of("Turtle$Type").with("Turtle", "Turtle$Type").write(folder.resolve(file));
    }
}
