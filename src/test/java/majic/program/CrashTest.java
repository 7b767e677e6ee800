package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests what a program that is killed leaves behind; a figure does so many times, with robots. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows keeps the files of a killed program open for a while")
class CrashTest {
    @TempDir
    private Path folder;

    @Test
    void aKilledProgramLeavesWholeLinesAndItsLastSettings() throws Exception {
        Crash crash = Crash.after(200, folder);

        assertThat(crash.logged()).allMatch(line -> line.startsWith("bots"));
        assertThat(crash.missingLines()).isNotNegative();
        assertThat(crash.settings().getProperty(CrashingSession.KEY))
                .satisfies(kept -> assertThat(Integer.parseInt(kept)).isGreaterThanOrEqualTo(crash.reportedSetting()));
        assertThat(Files.exists(folder.resolve("settings.properties.damaged"))).isFalse();
    }
}
