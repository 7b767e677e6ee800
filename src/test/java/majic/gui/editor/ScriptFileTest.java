package majic.gui.editor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.Set;
import majic.bot.BotException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ScriptFileTest {
    @TempDir
    private Path folder;

    private Path file(String content) throws IOException {
        return Files.writeString(folder.resolve("lap.majic"), content);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"1 move 5\n2 move 6\n", "1 move 5\r\n2 move 6\r\n", "\uFEFF1 move 5\r\n", "# Grüße\n1 stop"})
    void aFileThatIsSavedUnchangedKeepsAllItsBytes(String content) throws IOException {
        ScriptFile read = ScriptFile.read(file(content));
        assertThat(read.text()).doesNotContain("\r").doesNotContain("\uFEFF");
        read.write(read.text());
        assertThat(read.path()).content(StandardCharsets.UTF_8).isEqualTo(content);
    }

    @Test
    void aLatin1FileIsReadAndSavedAsUtf8() throws IOException {
        Path file = Files.write(folder.resolve("old.majic"), "# Grüße\n".getBytes(StandardCharsets.ISO_8859_1));
        ScriptFile read = ScriptFile.read(file);
        assertThat(read.isUtf8()).isFalse();
        assertThat(read.write(read.text()).isUtf8()).isTrue();
        assertThat(file).content(StandardCharsets.UTF_8).isEqualTo("# Grüße\n");
    }

    @Test
    void whatIsNoTextIsRefused() throws IOException {
        Path file = Files.write(folder.resolve("picture.majic"), new byte[] {1, 0, 2});
        assertThatThrownBy(() -> ScriptFile.read(file))
                .isInstanceOf(BotException.class)
                .hasMessageEndingWith("not a text");
        assertThatThrownBy(() -> ScriptFile.read(folder)).hasMessageContaining("it is a folder");
        assertThatThrownBy(() -> ScriptFile.read(folder.resolve("none"))).hasMessageContaining("there is no such file");
    }

    @Test
    void aChangeOfTheFileByAnotherProgramIsNoticed() throws IOException {
        ScriptFile read = ScriptFile.read(file("1 move 5\n"));
        assertThat(read.onDisk()).isEqualTo(ScriptFile.OnDisk.SAME);
        file("1 move 6\n");
        assertThat(read.onDisk()).isEqualTo(ScriptFile.OnDisk.CHANGED);
        Files.delete(read.path());
        assertThat(read.onDisk()).isEqualTo(ScriptFile.OnDisk.GONE);
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has other permissions, and links need a privilege")
    void savingKeepsPermissionsAndLinks() throws IOException {
        Path file = file("1 move 5\n");
        Set<PosixFilePermission> permissions =
                Set.of(PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE, PosixFilePermission.GROUP_READ);
        Files.setPosixFilePermissions(file, permissions);
        Path link = Files.createSymbolicLink(folder.resolve("link.majic"), file);
        ScriptFile.read(link).write("1 stop\n");
        assertThat(link).isSymbolicLink();
        assertThat(file).hasContent("1 stop\n");
        assertThat(Files.getPosixFilePermissions(file)).isEqualTo(permissions);
        try (var files = Files.list(folder)) {
            assertThat(files).hasSize(2);
        }
    }

    @Test
    void aFileThatCannotBeWrittenIsReported() {
        ScriptFile fresh = ScriptFile.fresh(folder.resolve("missing").resolve("lap.majic"));
        assertThatThrownBy(() -> fresh.write("1 stop"))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("cannot be written");
    }
}
