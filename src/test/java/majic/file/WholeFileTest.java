package majic.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class WholeFileTest {
    private static final String OLD = "1 move 5\n";
    private static final int LARGE_BYTES = 1_000_000;

    @TempDir
    private Path folder;

    private Path old() throws IOException {
        return Files.writeString(folder.resolve("lap.majic"), OLD);
    }

    private void assertNothingElseIsIn(Path in, int files) throws IOException {
        try (Stream<Path> found = Files.list(in)) {
            assertThat(found).hasSize(files);
        }
    }

    @Test
    void aFileIsCreatedAndReplaced() throws IOException {
        Path file = folder.resolve("new.majic");
        WholeFile.replace(file, OLD);
        assertThat(file).hasContent(OLD);
        WholeFile.replace(file, "1 stop\n");
        assertThat(file).hasContent("1 stop\n");
        assertNothingElseIsIn(folder, 1);
    }

    @Test
    void whileTheNewContentIsWrittenTheFileHasItsOldOne() throws IOException {
        Path file = old();
        WholeFile.replace(file, out -> {
            out.write(new byte[LARGE_BYTES]);
            assertThat(file).hasContent(OLD);
        });
        assertThat(file).hasSize(LARGE_BYTES);
    }

    @Test
    void aDiskThatIsFullHalfwayLeavesTheOldFileAndNothingElse() throws IOException {
        Path file = old();
        assertThatThrownBy(() -> WholeFile.replace(file, out -> {
                    out.write(new byte[LARGE_BYTES]);
                    throw new IOException("No space left on device");
                }))
                .isInstanceOf(IOException.class)
                .hasMessage("No space left on device");
        assertThat(file).hasContent(OLD);
        assertNothingElseIsIn(folder, 1);
    }

    @Test
    void anErrorInTheProgramLeavesTheOldFileAndNothingElse() throws IOException {
        Path file = old();
        assertThatThrownBy(() -> WholeFile.replace(file, out -> {
                    throw new IllegalStateException("wrong");
                }))
                .isInstanceOf(IllegalStateException.class);
        assertThat(file).hasContent(OLD);
        assertNothingElseIsIn(folder, 1);
    }

    @Test
    void aMissingFolderIsAnError() {
        assertThatThrownBy(() -> WholeFile.replace(folder.resolve("missing/lap.majic"), OLD))
                .isInstanceOf(NoSuchFileException.class);
    }

    @Test
    void aFolderIsNotReplaced() throws IOException {
        Path inside =
                Files.writeString(Files.createDirectory(folder.resolve("laps")).resolve("lap.majic"), OLD);
        assertThatThrownBy(() -> WholeFile.replace(folder.resolve("laps"), OLD)).isInstanceOf(IOException.class);
        assertThat(inside).hasContent(OLD);
        assertNothingElseIsIn(folder, 1);
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has other permissions, and links need a privilege")
    void permissionsAndLinksStay() throws IOException {
        Path file = old();
        Set<PosixFilePermission> permissions = PosixFilePermissions.fromString("rw-r-----");
        Files.setPosixFilePermissions(file, permissions);
        Path link = Files.createSymbolicLink(folder.resolve("link.majic"), file);
        WholeFile.replace(link, "1 stop\n");
        assertThat(link).isSymbolicLink();
        assertThat(file).hasContent("1 stop\n");
        assertThat(Files.getPosixFilePermissions(file)).isEqualTo(permissions);
        assertNothingElseIsIn(folder, 2);
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has other permissions")
    void aNewFileHasTheUsualPermissions() throws IOException {
        Path usual = Files.createFile(folder.resolve("usual"));
        Path file = folder.resolve("lap.majic");
        WholeFile.replace(file, OLD);
        assertThat(Files.getPosixFilePermissions(file)).isEqualTo(Files.getPosixFilePermissions(usual));
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows permits new files in a folder marked as read-only")
    void aReadOnlyFolderIsAnErrorAndTheFileStays() throws IOException {
        Path file = old();
        Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("r-xr-xr-x"));
        try {
            assumeThat(Files.isWritable(folder))
                    .as("an administrator, to whom permissions do not apply")
                    .isFalse();
            assertThatThrownBy(() -> WholeFile.replace(file, "1 stop\n")).isInstanceOf(AccessDeniedException.class);
            assertThat(file).hasContent(OLD);
        } finally {
            Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
        }
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no named pipes in folders")
    void aPipeIsWrittenAndStaysAPipe() throws Exception {
        Path pipe = folder.resolve("pipe");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();
        CompletableFuture<String> read = new CompletableFuture<>();
        Thread reader = new Thread(() -> read.completeAsync(() -> read(pipe)), "reader of the pipe");
        reader.start();
        WholeFile.replace(pipe, OLD);
        assertThat(read.get()).isEqualTo(OLD);
        assertThat(Files.isRegularFile(pipe)).isFalse();
    }

    private static String read(Path pipe) {
        try {
            return Files.readString(pipe);
        } catch (IOException e) {
            return String.valueOf(e);
        }
    }
}
