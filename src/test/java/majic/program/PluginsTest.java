package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.bot.Settings;
import majic.team.BotFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Tests robot types in jars in the plug-ins folder. */
@Tag("jdk")
@Timeout(30)
class PluginsTest {
    private static final String SERVICES = "META-INF/services/majic.bot.BotType";

    @TempDir
    private Path folder;

    @Test
    void withoutPluginsThereAreTheThreeRobotsOfTheThesis() {
        assertThat(Plugins.types(folder.resolve("none")))
                .extracting(BotType::name)
                .containsExactly("aibo", "pioneer", "hemisson");
    }

    @Test
    void aJarInTheFolderBringsAnotherTypeAndItsRobotMoves() throws IOException {
        jar("turtle.jar", "Turtle$Type", "Turtle.class", "Turtle$Type.class");
        BotFactory factory = new BotFactory(Plugins.types(folder), Settings.inMemory());

        try (MajicBot turtle = factory.create("turtle://here")) {
            turtle.connect();

            assertThat(turtle.move(10).amount()).hasToString("about 10 mm");
            turtle.set("pen", "on");
            assertThat(turtle.get("pen")).hasToString("on");
        }
    }

    @Test
    void aBrokenPluginLeavesTheOthersAlone() throws IOException {
        jar("broken.jar", "NoSuchClass");
        Files.writeString(folder.resolve("rubbish.jar"), "this is no jar");

        assertThat(Plugins.types(folder)).extracting(BotType::name).containsExactly("aibo", "pioneer", "hemisson");
    }

    private void jar(String name, String type, String... classes) throws IOException {
        try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(folder.resolve(name)))) {
            jar.putNextEntry(new JarEntry(SERVICES));
            jar.write(type.getBytes(StandardCharsets.UTF_8));
            for (String file : List.of(classes)) {
                jar.putNextEntry(new JarEntry(file));
                try (InputStream code = PluginsTest.class.getResourceAsStream("/" + file)) {
                    jar.write(code.readAllBytes());
                }
            }
        }
    }
}
