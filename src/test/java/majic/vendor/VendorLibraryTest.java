package majic.vendor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.environment.Settings;
import majic.vendor.probe.ProbeAdapter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests how an installed library is found and loaded, and the sentences for all that can be wrong with it. */
@Tag("jdk")
class VendorLibraryTest {
    private static final String EVENT = """
            package liburbi.call;
            public class URBIEvent {
                public String getCmd() {
                    return "the installed one";
                }
            }
            """;

    @TempDir
    private Path folder;

    private final Settings settings = Settings.inMemory();

    @ParameterizedTest
    @ValueSource(strings = {"liburbi.jar", "lib/any-name.jar", "java/liburbi-2004.jar"})
    void anAdapterUsesTheInstalledLibrary(String jar) throws IOException {
        install(jar, Map.of("liburbi/call/URBIEvent.java", EVENT, "liburbi/UClient.java", client()));

        Supplier<?> adapter = create();

        assertThat(adapter.get()).isEqualTo("the installed one by liburbi-java");
        assertThat(adapter).isNotInstanceOf(ProbeAdapter.class);
    }

    @Test
    void aSecondAdapterUsesTheSameClasses() throws IOException {
        install("liburbi.jar", Map.of("liburbi/call/URBIEvent.java", EVENT, "liburbi/UClient.java", client()));

        assertThat(create().getClass()).isSameAs(create().getClass());
    }

    @Test
    void whatTheInstalledLibraryLacksIsNotTakenFromTheProgram() throws IOException {
        install("liburbi.jar", Map.of("liburbi/UClient.java", client()));
        Supplier<?> adapter = create();

        assertThatThrownBy(adapter::get).isInstanceOf(NoClassDefFoundError.class);
    }

    @Test
    void aLibraryThatIsNotNamedIsMissed() {
        assertThatThrownBy(() -> VendorHome.find(VendorLibrary.ARIA, settings, name -> null, name -> null))
                .isInstanceOf(BotException.class)
                .hasMessage("ARIA is not found: name the folder where it is installed with --aria-home DIR, in the"
                        + " environment variable ARIA, or as aria.home in MAJIC's settings");
    }

    @Test
    void theCommandLineComesBeforeTheEnvironmentAndThatBeforeTheSettings() throws IOException {
        List<Path> homes = List.of(
                Files.createDirectory(folder.resolve("a")),
                Files.createDirectory(folder.resolve("b")),
                Files.createDirectory(folder.resolve("c")));
        settings.put("aria.home", homes.get(2).toString());
        Map<String, String> property = Map.of("aria.home", homes.get(0).toString());
        Map<String, String> variable = Map.of("ARIA", homes.get(1).toString());

        assertThat(VendorHome.find(VendorLibrary.ARIA, settings, property::get, variable::get))
                .hasToString(homes.get(0) + " (from --aria-home)");
        assertThat(VendorHome.find(VendorLibrary.ARIA, settings, name -> null, variable::get))
                .hasToString(homes.get(1) + " (from the environment variable ARIA)");
        assertThat(VendorHome.find(VendorLibrary.ARIA, settings, name -> "", name -> null))
                .hasToString(homes.get(2) + " (from the setting aria.home)");
    }

    @Test
    void aTildeIsTheUsersFolder() {
        Map<String, String> property = Map.of("aria.home", "~");

        assertThat(VendorHome.find(VendorLibrary.ARIA, settings, property::get, name -> null)
                        .folder())
                .isEqualTo(Path.of(System.getProperty("user.home")));
    }

    @Test
    void aFolderThatDoesNotExistIsNamed() {
        assertRefused(
                VendorLibrary.LIBURBI,
                folder.resolve("none"),
                "liburbi-java is not found: there is no folder " + folder.resolve("none")
                        + " (from the setting liburbi.home)");
    }

    @Test
    void aFolderWithoutTheLibraryIsNamedWithWhatWasLookedFor() throws IOException {
        Files.writeString(folder.resolve("broken.jar"), "no jar");
        assertRefused(
                VendorLibrary.LIBURBI,
                folder,
                "liburbi-java is not found: no jar in " + folder
                        + " (from the setting liburbi.home), neither in it or its"
                        + " folders java, lib, lib64, bin, bin64, dist, has the class liburbi.UClient");
    }

    @Test
    void anOtherVersionIsNamed() throws IOException {
        install("liburbi.jar", Map.of("liburbi/UClient.java", "package liburbi; public interface UClient {}"));
        settings.put("liburbi.home", folder.toString());

        assertThatThrownBy(() -> VendorLibrary.LIBURBI.create(Supplier.class, "majic.vendor.probe.Missing", settings))
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith("liburbi-java in " + folder
                        + " (from the setting liburbi.home) is not the version that MAJIC can use, or damaged: ");
    }

    @Test
    void anInstallationWithoutItsNativeLibraryIsNamed() throws IOException {
        installAria();
        assertRefused(
                VendorLibrary.ARIA,
                folder,
                "ARIA is not complete: there is no " + System.mapLibraryName("AriaJava") + " in " + folder
                        + " (from the setting aria.home), neither in it or its folders java, lib, lib64, bin, bin64, dist");
    }

    @Test
    void aLibraryForAnotherProcessorIsNamed() throws IOException {
        installAria();
        Path library = nativeLibrary("AriaJava", elf(1, 3));
        String other = System.getProperty("os.name").equals("Linux")
                ? "ARIA does not fit this Java: " + library + " is made for another processor than "
                        + System.getProperty("os.arch") + "; install its build for that"
                : "ARIA ";
        assertRefused(VendorLibrary.ARIA, folder, other);
    }

    @Test
    void aDamagedLibraryIsNamed() throws IOException {
        installAria();
        Path library = nativeLibrary("Aria", elf(2, 0));
        nativeLibrary("AriaJava", new byte[0]);
        assertRefused(VendorLibrary.ARIA, folder, "ARIA cannot be loaded from " + library + ": ");
    }

    @Test
    void anotherFolderCanBeUsedAfterOneWhoseNativeLibraryCannotBeLoaded() throws IOException {
        aDamagedLibraryIsNamed();
        Path other = Files.createDirectory(folder.resolve("other"));
        Files.copy(folder.resolve("java/Aria.jar"), other.resolve("Aria.jar"));

        assertRefused(VendorLibrary.ARIA, other, "ARIA is not complete: ");
    }

    @Test
    void aProgramOnlyCompilesAgainstTheSignaturesAndHasNoneOfThem() throws IOException {
        Path classes = Path.of(VendorLibrary.class
                .getProtectionDomain()
                .getCodeSource()
                .getLocation()
                .getPath());
        for (String other : List.of("com", "liburbi", "signatures")) {
            assertThat(classes.resolve(other)).doesNotExist();
        }
    }

    private void assertRefused(VendorLibrary library, Path home, String message) {
        settings.put(library.property(), home.toString());
        assertThatThrownBy(() -> library.create(Supplier.class, ProbeAdapter.class.getName(), settings))
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith(message);
    }

    private Supplier<?> create() {
        settings.put("liburbi.home", folder.toString());
        return VendorLibrary.LIBURBI.create(Supplier.class, ProbeAdapter.class.getName(), settings);
    }

    private static String client() {
        return "package liburbi; public class UClient {}";
    }

    private void installAria() throws IOException {
        install("java/Aria.jar", Map.of("com/mobilerobots/Aria/ArRobot.java", """
                package com.mobilerobots.Aria;
                public class ArRobot {}
                """));
    }

    private Path nativeLibrary(String name, byte[] content) throws IOException {
        Path file = Files.createDirectories(folder.resolve("lib")).resolve(System.mapLibraryName(name));
        return Files.write(file, content);
    }

    /**
     * The head of a library. Where Java looks whether a 64-bit library runs code on the stack, it finds that this one
     * does not, so that Java prints no warning.
     *
     * @param wordSize 1 for 32 bits, 2 for 64
     * @param type 3 for a library that can be loaded
     */
    private static byte[] elf(int wordSize, int type) {
        ByteBuffer file = ByteBuffer.allocate(4096).order(ByteOrder.LITTLE_ENDIAN);
        file.put(new byte[] {0x7F, 'E', 'L', 'F', (byte) wordSize, 1, 1});
        file.putShort(16, (short) type).putShort(18, (short) 3).putInt(20, 1);
        file.putLong(32, 64).putShort(56, (short) 1).putInt(64, 0x6474E551).putInt(68, 6);
        return file.array();
    }

    /** Compiles sources into a jar in the folder. */
    private void install(String jar, Map<String, String> sources) throws IOException {
        Path work = Files.createTempDirectory(folder, "work");
        for (Map.Entry<String, String> source : sources.entrySet()) {
            Path file = work.resolve(source.getKey());
            Files.createDirectories(file.getParent());
            Files.writeString(file, source.getValue());
        }
        VendorJar.compile(work, folder.resolve(jar));
    }
}
