package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import majic.text.OneSentence;
import org.junit.jupiter.api.io.TempDir;

/** Arbitrary settings files: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md). */
class UserSettingsFuzzTest {
    @TempDir
    private Path folder;

    private final List<String> alarms = new ArrayList<>();

    @FuzzTest
    void anyFileIsReadAndKeptOrPutAsideAndReported(byte[] content) throws IOException {
        Path file = folder.resolve("settings.properties");
        Path aside = folder.resolve("settings.properties.damaged");
        Files.deleteIfExists(aside);
        Files.write(file, content);
        alarms.clear();

        Map<String, String> read = all(open(file));
        UserSettings settings = open(file);
        settings.put("look", "dark");
        read.put("look", "dark");

        assertThat(all(open(file))).isEqualTo(read);
        assertThat(alarms).hasSize(Files.exists(aside) ? 1 : 0).allSatisfy(OneSentence::check);
        if (Files.exists(aside)) {
            assertThat(Files.readAllBytes(aside)).isEqualTo(content);
            assertThat(read).hasSize(1);
        }
    }

    private UserSettings open(Path file) {
        UserSettings settings = new UserSettings(file);
        settings.onTrouble(alarms::add);
        return settings;
    }

    private static Map<String, String> all(UserSettings settings) {
        Map<String, String> all = new TreeMap<>();
        settings.keys("").forEach(key -> all.put(key, settings.get(key).orElseThrow()));
        return all;
    }
}
