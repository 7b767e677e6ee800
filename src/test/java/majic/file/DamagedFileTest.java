package majic.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DamagedFileTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"", "2 turn 90°\n", "1 move 5\r\n\t# Grüße\n"})
    void aTextIsNotDamaged(String text) {
        assertThat(DamagedFile.isDamagedText(text.getBytes(StandardCharsets.UTF_8)))
                .isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1 move 5\n\0\0\0\0", "2 turn 90\u00B0\n", "\u001B[2J"})
    void zerosControlCharactersAndOtherEncodingsAreDamage(String text) {
        assertThat(DamagedFile.isDamagedText(text.getBytes(StandardCharsets.ISO_8859_1)))
                .isTrue();
    }

    @Test
    void eachDamagedFileGetsANameOfItsOwn() throws IOException {
        Path file = folder.resolve("lab.team");
        Files.writeString(file, "first");
        assertThat(DamagedFile.rename(file)).hasFileName("lab.team.damaged").hasContent("first");
        assertThat(file).doesNotExist();
        Files.writeString(file, "second");
        assertThat(DamagedFile.copy(file)).hasFileName("lab.team.damaged-2").hasContent("second");
        assertThat(file).hasContent("second");
        assertThat(folder.resolve("lab.team.damaged")).hasContent("first");
    }
}
