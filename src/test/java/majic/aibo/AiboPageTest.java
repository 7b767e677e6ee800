package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.bot.RobotPage;
import org.junit.jupiter.api.Test;

/** The page about the Aibo lists what the driver describes, word for word. */
class AiboPageTest {
    private static final Path PAGE = Path.of("docs", "robots", "aibo.md");

    @Test
    void listsEveryParameter() throws IOException {
        try (MajicAibo dog = new MajicAibo("aibo://127.0.0.1:1")) {
            assertThat(Files.readString(PAGE)).contains(RobotPage.parameters(dog));
        }
    }

    @Test
    void listsEveryCommand() throws IOException {
        try (MajicAibo dog = new MajicAibo("aibo://127.0.0.1:1")) {
            assertThat(Files.readString(PAGE)).contains(RobotPage.commands(dog));
        }
    }
}
