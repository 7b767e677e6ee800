package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.bot.RangeScan;
import majic.environment.Settings;
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
    void withoutPluginsThereAreTheRobotsOfTheThesisAndThoseThatSpeakRos() {
        assertThat(Plugins.in(folder.resolve("none")).types())
                .extracting(BotType::name)
                .containsExactly("aibo", "pioneer", "hemisson", "ros", "mavlink", "mqtt");
    }

    @Test
    void aJarInTheFolderBringsAnotherTypeAndItsRobotMoves() throws IOException {
        turtle("turtle.jar");
        BotFactory factory = new BotFactory(Plugins.in(folder).types(), Settings.inMemory());

        try (MajicBot turtle = factory.create("turtle://here")) {
            CompletableFuture<RangeScan> seen = new CompletableFuture<>();
            turtle.addScanListener(seen::complete);
            turtle.connect();

            assertThat(seen.join().sensor()).isEqualTo(turtle.rangeSensors().get(0));
            assertThat(seen.join().rangeMm(0)).isEqualTo(1000);
            assertThat(turtle.move(10).amount()).hasToString("about 10 mm");
            turtle.set("pen", "on");
            assertThat(turtle.get("pen")).hasToString("on");
        }
    }

    private void turtle(String file) throws IOException {
        PluginJar.of("Turtle$Type").with("Turtle", "Turtle$Type").write(folder.resolve(file));
    }
}
