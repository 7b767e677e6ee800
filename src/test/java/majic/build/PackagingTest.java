package majic.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The program that makes the image and the installer of MAJIC, which is no part of the jar. */
@Tag("jdk")
class PackagingTest {
    @TempDir
    private Path folder;

    @Test
    void itsSourceCompilesWithTheLibrariesOfMajic() throws Exception {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter problems = new StringWriter();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
            List<String> options =
                    List.of("-proc:none", "-d", "" + folder, "-classpath", System.getProperty("java.class.path"));
            boolean compiled = compiler.getTask(
                            problems,
                            files,
                            null,
                            options,
                            null,
                            files.getJavaFileObjects(Path.of("src/build/Packaging.java")))
                    .call();
            assertThat(compiled).as(problems.toString()).isTrue();
        }
    }
}
