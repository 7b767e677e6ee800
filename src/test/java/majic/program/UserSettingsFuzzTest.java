package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import majic.file.FuzzedFile;
import org.junit.jupiter.api.io.TempDir;

/**
 * Arbitrary settings files: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md).
 */
class UserSettingsFuzzTest {
    @TempDir
    private Path folder;

    @FuzzTest
    void anyFileIsReadAndKeptOrPutAsideAndReported(byte[] content) throws IOException {
        FuzzedFile file = FuzzedFile.write(folder.resolve("settings.properties"), content);

        Map<String, String> read = all(open(file));
        UserSettings settings = open(file);
        settings.put("look", "dark");
        read.put("look", "dark");

        assertThat(all(open(file))).isEqualTo(read);
        if (file.isKeptAsDamaged()) {
            assertThat(read).hasSize(1);
        }
    }

    private static UserSettings open(FuzzedFile file) {
        UserSettings settings = new UserSettings(file.path());
        settings.onTrouble(file::alarm);
        return settings;
    }

    private static Map<String, String> all(UserSettings settings) {
        Map<String, String> all = new TreeMap<>();
        settings.keys("").forEach(key -> all.put(key, settings.get(key).orElseThrow()));
        return all;
    }
}
