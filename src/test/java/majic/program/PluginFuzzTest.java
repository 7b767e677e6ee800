package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.text.OneSentence;
import org.junit.jupiter.api.io.TempDir;

/** Arbitrary plug-ins: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md). */
class PluginFuzzTest {
    @TempDir
    private Path folder;

    @FuzzTest
    void anyJarIsAPlugInOrAProblemWithItsName(byte[] jar) throws IOException {
        Files.write(folder.resolve("odd.jar"), jar);
        assertLoads();
    }

    @FuzzTest
    void anyListOfTypesIsReadOrAProblemWithItsName(byte[] services) throws IOException {
        PluginJar.of(new String(services, StandardCharsets.UTF_8)).write(folder.resolve("odd.jar"));
        assertLoads();
    }

    private void assertLoads() {
        Plugins plugins = Plugins.in(folder);

        assertThat(plugins.problems()).allSatisfy(problem -> {
            assertThat(problem).startsWith("plug-in odd.jar: ");
            OneSentence.check(problem);
        });
        assertThat(plugins.types())
                .hasSizeGreaterThanOrEqualTo(
                        Plugins.in(folder.resolve("none")).types().size());
    }
}
