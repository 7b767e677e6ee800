package majic.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the user's settings survive a file that is damaged or cannot be read. */
class UserSettingsTest {
    private static final String GOOD = "aibo.10.0.0.5.forward=9.5\nact.trusted=abc\n";

    @TempDir
    Path folder;

    private final List<String> told = new ArrayList<>();
    private Path file;

    @BeforeEach
    void nameTheFile() {
        file = folder.resolve("settings.properties");
    }

    private UserSettings settings() {
        UserSettings settings = new UserSettings(file);
        settings.onTrouble(told::add);
        return settings;
    }

    @Test
    void whatWasPutIsThereAtTheNextStart() {
        settings().put("look", "dark");

        assertThat(settings().get("look")).contains("dark");
        assertThat(told).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"bad=\\u00zz\n", "bad=\u00FF\n"})
    void aDamagedFileIsKeptAsideAndReportedAndNeverOverwritten(String damage) throws IOException {
        byte[] damaged = (GOOD + damage).getBytes(StandardCharsets.ISO_8859_1);
        Files.write(file, damaged);
        UserSettings settings = settings();

        assertThat(settings.get("act.trusted")).isEmpty();
        settings.put("look", "dark");

        Path aside = folder.resolve("settings.properties.damaged");
        assertThat(Files.readAllBytes(aside)).isEqualTo(damaged);
        assertThat(told).singleElement().asString().contains("were damaged", aside.toString());
        assertThat(settings().get("look")).contains("dark");
    }

    @Test
    void aSecondDamagedFileIsKeptBesideTheFirst() throws IOException {
        for (int start = 0; start < 2; start++) {
            Files.writeString(file, GOOD + "bad=\\u00zz\n");
            settings().get("look");
        }

        assertThat(folder.resolve("settings.properties.damaged")).exists();
        assertThat(folder.resolve("settings.properties.damaged-2")).exists();
    }

    @Test
    void aFileThatCannotBeReadIsNotWrittenUntilItCan() throws IOException {
        Files.createDirectory(file);
        UserSettings settings = settings();

        assertThat(settings.get("act.trusted")).isEmpty();
        assertThatThrownBy(() -> settings.put("look", "dark"))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("cannot be read");
        assertThat(settings.get("look")).contains("dark");
        assertThat(told).singleElement().asString().contains("cannot read the settings");

        Files.delete(file);
        Files.writeString(file, GOOD);
        settings.put("sound", "off");

        assertThat(Files.readAllLines(file)).contains("act.trusted=abc", "look=dark", "sound=off");
    }

    @Test
    void settingsThatCannotBeWrittenLeaveTheFileAsItWas() throws IOException {
        Files.writeString(file, GOOD);
        UserSettings settings = settings();
        assertThat(settings.get("act.trusted")).contains("abc");
        Path elsewhere = Files.move(folder, folder.resolveSibling(folder.getFileName() + "-away"));
        Files.createFile(folder);

        assertThatThrownBy(() -> settings.put("look", "dark"))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("cannot write the settings");

        Files.delete(folder);
        Files.move(elsewhere, folder);
        assertThat(Files.readString(file)).isEqualTo(GOOD);
        settings.put("sound", "off");
        assertThat(Files.readAllLines(file)).contains("act.trusted=abc", "look=dark", "sound=off");
    }

    @Test
    void errorsAreReportedToTheFirstListener() throws IOException {
        Files.writeString(file, "bad=\\u00zz\n");
        UserSettings settings = new UserSettings(file);
        settings.get("look");

        settings.onTrouble(told::add);

        assertThat(told).hasSize(1);
    }
}
