package majic.vendor;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/** Makes jars that stand for a vendor's. */
public final class VendorJar {
    private VendorJar() {}

    /**
     * Compiles all sources below a folder, without this program's classes.
     *
     * @param jar to be written; its folder is made
     */
    public static void compile(Path sources, Path jar) throws IOException {
        Path classes = Files.createTempDirectory("vendor");
        List<String> options = Stream.concat(
                        Stream.of("-proc:none", "-cp", "" + classes, "-d", "" + classes),
                        files(sources, ".java").stream().map(Path::toString))
                .toList();
        assertThat(ToolProvider.getSystemJavaCompiler().run(null, null, null, options.toArray(String[]::new)))
                .isZero();
        Files.createDirectories(jar.getParent());
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            for (Path file : files(classes, ".class")) {
                out.putNextEntry(
                        new JarEntry(classes.relativize(file).toString().replace('\\', '/')));
                Files.copy(file, out);
            }
        }
    }

    private static List<Path> files(Path folder, String ending) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(file -> file.toString().endsWith(ending)).toList();
        }
    }
}
