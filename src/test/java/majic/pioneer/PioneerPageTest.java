package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.bot.RobotPage;
import majic.pioneer.state.Bumpers;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.Limits;
import majic.pioneer.state.Models;
import org.junit.jupiter.api.Test;

/** The page about the Pioneer lists the parameters as the driver describes them. */
class PioneerPageTest {
    private static final Path PAGE = Path.of("docs", "robots", "pioneer.md");

    @Test
    void listsEveryParameter() throws IOException {
        try (MajicPioneer bot = wellEquipped()) {
            assertThat(Files.readString(PAGE)).contains(RobotPage.parameters(bot));
        }
    }

    @Test
    void listsEveryCommand() throws IOException {
        try (MajicPioneer bot = wellEquipped()) {
            assertThat(Files.readString(PAGE)).contains(RobotPage.commands(bot));
        }
    }

    private static MajicPioneer wellEquipped() {
        MajicPioneer bot = new MajicPioneer("pioneer://127.0.0.1:1");
        bot.describe(
                new Equipment(Models.USUAL, true, new Bumpers(5, 5), true, true, true, Limits.of(Models.USUAL, null)));
        return bot;
    }
}
