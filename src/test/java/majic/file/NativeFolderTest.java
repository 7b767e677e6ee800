package majic.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no modes of files")
class NativeFolderTest {
    @TempDir
    Path home;

    @Test
    void theFolderIsCreatedForThisUserAlone() throws IOException {
        Path folder = NativeFolder.find(List.of(() -> home.resolve("cache/native")));

        assertThat(folder).isEqualTo(home.toRealPath().resolve("cache/native")).isEmptyDirectory();
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folder)))
                .isEqualTo("rwx------");
    }

    @Test
    void aFolderThatOtherUsersMayWriteIsNotUsed() throws IOException {
        Path open = folder("open", "rwxrwxrwx");

        assertThat(NativeFolder.find(List.of(() -> open, () -> home.resolve("own"))))
                .isEqualTo(home.toRealPath().resolve("own"));
    }

    @Test
    void aFolderThatOtherUsersMayReplaceIsNotUsed() throws IOException {
        Path shared = folder("shared", "rwxrwxrwx");

        assertThatThrownBy(() -> NativeFolder.find(List.of(() -> shared.resolve("native"))))
                .hasMessageContaining("can be replaced by other users, who may write to " + shared);
    }

    @Test
    void aLinkInPlaceOfTheFolderIsNotFollowed() throws IOException {
        Path elsewhere = folder("elsewhere", "rwx------");
        Path link = Files.createSymbolicLink(home.resolve("link"), elsewhere);

        assertThatThrownBy(() -> NativeFolder.find(List.of(() -> link)))
                .hasMessageContaining(link + " is not a folder");
    }

    @Test
    void withoutAFolderTheMessageNamesEachAndTheRemedy() throws IOException {
        Path open = folder("open", "rwxrwxrwx");
        Path file = Files.createFile(home.resolve("file"));

        assertThatThrownBy(() -> NativeFolder.find(List.of(() -> open, () -> file.resolve("native"))))
                .isInstanceOf(IOException.class)
                .hasMessage("native code can be loaded from no folder of this user: " + open
                        + " is open to other users, " + file.resolve("native")
                        + " cannot be created; can the environment variable MAJIC_NATIVE name a folder of yours on a"
                        + " file system that is not mounted with noexec?");
    }

    @Test
    void theFolderThatTheUserHasChosenIsTheOnlyOne() {
        assertThat(places(Map.of("MAJIC_NATIVE", "/opt/me", "XDG_CACHE_HOME", "/caches"), "Linux"))
                .containsExactly("/opt/me/majic-native");
    }

    @Test
    void theFolderIsAmongTheCachesOfTheUser() {
        assertThat(places(Map.of("XDG_CACHE_HOME", "/caches"), "Linux")).first().isEqualTo("/caches/majic/native");
        assertThat(places(Map.of(), "Linux")).first().isEqualTo("/home/me/.cache/majic/native");
        assertThat(places(Map.of(), "Mac OS X")).first().isEqualTo("/home/me/Library/Caches/MAJIC/native");
    }

    @Test
    void aHomeThatIsUnknownLeavesANewTemporaryFolder() throws IOException {
        List<Supplier<Path>> candidates = NativeFolder.candidates(Map.of(), "Linux", "?");

        assertThat(candidates).hasSize(1);
        assertThat(NativeFolder.find(candidates)).isEmptyDirectory();
    }

    @Test
    void whileALibraryIsLoadedItsTemporaryFolderIsThePrivateOne() throws IOException {
        String usual = System.getProperty("java.io.tmpdir");

        String during = NativeFolder.load(() -> System.getProperty("java.io.tmpdir"));

        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(Path.of(during))))
                .isEqualTo("rwx------");
        assertThat(System.getProperty("java.io.tmpdir")).isEqualTo(usual);
    }

    private static List<String> places(Map<String, String> environment, String system) {
        return NativeFolder.candidates(environment, system, "/home/me").stream()
                .map(Supplier::get)
                .map(Path::toString)
                .toList();
    }

    private Path folder(String name, String permissions) throws IOException {
        Path folder = Files.createDirectory(home.resolve(name));
        Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString(permissions));
        return folder.toRealPath();
    }
}
