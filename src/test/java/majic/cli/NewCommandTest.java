package majic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import majic.act.make.ActMaker;
import majic.bot.BotAddress;
import majic.bot.BotType;
import majic.environment.BotEnvironment;
import majic.program.Plugins;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

/** Tests the projects that are written for a new robot and a new act. */
@Tag("jdk")
class NewCommandTest {
    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return new CommandLine(new NewCommand())
                .setOut(new PrintWriter(out))
                .setErr(new PrintWriter(err))
                .execute(arguments);
    }

    /** Compiles all sources of a project, its tests included; returns the folder of the classes. */
    private Path compile(Path project) throws IOException {
        Path classes = Files.createDirectories(folder.resolve("classes"));
        List<String> arguments = new ArrayList<>(
                List.of("-Xlint:all,-processing", "-proc:none", "-d", classes.toString(), "-cp", path()));
        try (Stream<Path> files = Files.walk(project)) {
            files.filter(file -> file.toString().endsWith(".java"))
                    .map(Path::toString)
                    .forEach(arguments::add);
        }
        int status = ToolProvider.getSystemJavaCompiler().run(null, null, System.err, arguments.toArray(String[]::new));
        assertThat(status).isZero();
        return classes;
    }

    private static String path() {
        return System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
    }

    @Test
    void theProjectOfARobotCompilesAndItsJarIsAPlugin() throws IOException {
        Path project = folder.resolve("moon");

        assertThat(run("robot", "Rover", project.toString())).isZero();

        Path classes = compile(project);
        assertThat(classes.resolve("rover/RoverTest.class")).exists();
        Path jar = Files.createDirectories(folder.resolve("plugins")).resolve("rover.jar");
        pack(jar, classes, project.resolve("src/main/resources"));
        Plugins plugins = Plugins.in(jar.getParent());
        assertThat(plugins.problems()).isEmpty();
        assertThat(plugins.types())
                .filteredOn(type -> type.name().equals("rover"))
                .singleElement()
                .extracting(
                        BotType::label,
                        type -> type.create(BotAddress.parse("rover://moon:4000"), BotEnvironment.plain())
                                .name())
                .containsExactly("Rover", "the Rover");
    }

    private static void pack(Path jar, Path... contents) throws IOException {
        try (JarOutputStream packed = new JarOutputStream(Files.newOutputStream(jar))) {
            for (Path content : contents) {
                try (Stream<Path> files = Files.walk(content)) {
                    for (Path file : files.filter(Files::isRegularFile).toList()) {
                        packed.putNextEntry(
                                new JarEntry(content.relativize(file).toString().replace('\\', '/')));
                        packed.write(Files.readAllBytes(file));
                    }
                }
            }
        }
    }

    @Test
    void theProjectOfAnActCompilesAndHasOneAct() throws IOException {
        Path project = folder.resolve("project");

        assertThat(run("act", "explore", project.toString())).isZero();

        Path classes = compile(project);
        assertThat(classes.resolve("explore/ExploreTest.class")).exists();
        assertThat(ActMaker.from(classes).onlyAct()).isEqualTo("explore.Explore");
    }

    @Test
    void nothingOfTheExampleIsLeftInAProject() throws IOException {
        run("robot", "Rover", folder.resolve("r").toString());
        run("act", "Explore", folder.resolve("a").toString());

        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                assertThat(file + Files.readString(file))
                        .doesNotContainIgnoringCase("cart", "pacer")
                        .doesNotContainPattern("@[\\w.]+@");
            }
        }
    }

    @Test
    void theFilesThatWereWrittenAreListed() {
        Path project = folder.resolve("rover");

        run("robot", "Rover", project.toString());

        assertThat(out.toString())
                .contains("wrote " + project.resolve("pom.xml"), "wrote " + project.resolve("README.md"))
                .endsWith(
                        "README.md in it describes how to build it and where MAJIC finds it" + System.lineSeparator());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "robot | 2Fast | cannot be the name of a class and a package in Java",
                "robot | moon-rover | cannot be the name of a class and a package in Java",
                "act | Switch | cannot be the name of a class and a package in Java",
                "robot | Pioneer | MAJIC has a type of robot of this name; choose another one",
                "robot | Sim | MAJIC has a type of robot of this name; choose another one",
                "robot | Pose | the project uses another class of this name; choose another one",
                "act | string | the project uses another class of this name; choose another one"
            })
    void aNameThatCannotBeUsedIsRefused(String kind, String name, String reason) {
        Path project = folder.resolve("project");

        assertThat(run(kind, name, project.toString())).isEqualTo(1);

        assertThat(err.toString()).startsWith("majic: " + name + ": " + reason);
        assertThat(project).doesNotExist();
    }

    @Test
    void aFolderWithFilesIsLeftAsItIs() throws IOException {
        Files.writeString(folder.resolve("notes.txt"), "mine");

        assertThat(run("robot", "Rover", folder.toString())).isEqualTo(1);

        assertThat(err.toString())
                .isEqualTo("majic: " + folder + ": is not empty; name a folder that does not exist yet"
                        + System.lineSeparator());
        assertThat(folder).isDirectoryContaining(file -> file.endsWith("notes.txt"));
        assertThat(folder.resolve("pom.xml")).doesNotExist();
    }

    @Test
    void withoutAKindItListsTheKinds() {
        assertThat(run()).isEqualTo(2);

        assertThat(err.toString()).contains("robot", "act");
    }
}
