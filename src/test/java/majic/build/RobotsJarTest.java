package majic.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.File;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.simulation.SimulatedLab;
import majicsim.LabOptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that the jar for programs that embed robots has all that these need beside the two libraries that come with it.
 */
@Tag("jdk")
class RobotsJarTest {
    private static final Path CLASSES = Path.of(System.getProperty("majic.target", "target"), "classes");

    /**
     * Loaded only where there is a window, JNA, a robot maker's library, a robot that speaks ROS and so needs JSON, or
     * a robot of another desk, which needs MQTT, or a map that is built, which needs EJML.
     */
    private static final Pattern OPTIONAL = Pattern.compile(
            "majic\\.\\w+\\.panel\\..*|com\\.sun\\.jna\\..*"
                    + "|com\\.mobilerobots\\..*|liburbi\\..*|com\\.fasterxml\\.jackson\\..*|com\\.hivemq\\..*|io\\.netty\\..*|io\\.reactivex\\..*|org\\.ejml\\..*");

    private static final Pattern LIBRARY =
            Pattern.compile("java\\..*|javax\\..*|com\\.fazecast\\..*|org\\.jspecify\\..*");

    @TempDir
    Path jar;

    /** Copies what the build puts into the jar. */
    @BeforeEach
    void copyTheContentOfTheJar() throws IOException {
        String pom = Files.readString(Path.of("pom.xml"));
        String list = pom.substring(
                pom.indexOf("<classifier>robots<"), pom.indexOf("</excludes>", pom.indexOf("<classifier>robots<")));
        List<PathMatcher> included = matchers(list, "include");
        List<PathMatcher> excluded = matchers(list, "exclude");
        try (Stream<Path> files = Files.walk(CLASSES)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Path name = CLASSES.relativize(file);
                if (included.stream().anyMatch(matcher -> matcher.matches(name))
                        && excluded.stream().noneMatch(matcher -> matcher.matches(name))) {
                    Files.createDirectories(jar.resolve(name).getParent());
                    Files.copy(file, jar.resolve(name));
                }
            }
        }
    }

    private static List<PathMatcher> matchers(String list, String element) {
        return Pattern.compile("<" + element + ">(.*?)</")
                .matcher(list)
                .results()
                .map(match -> FileSystems.getDefault().getPathMatcher("glob:" + match.group(1)))
                .toList();
    }

    @Test
    void theGuideNamesTheVersionThatIsBuilt() throws IOException {
        String version = Files.readString(Path.of("pom.xml")).replaceFirst("(?s).*?(<version>.*?</version>).*", "$1");
        assertThat(Files.readString(Path.of("docs/programmers-guide.md")))
                .containsSubsequence(version, "<classifier>robots</classifier>");
    }

    @Test
    void thePageOnPluginsNamesTheVersionsThatAreBuilt() throws IOException {
        String pom = Files.readString(Path.of("pom.xml"));
        assertThat(Files.readString(Path.of("docs/plugins.md")))
                .containsSubsequence(
                        "<version>" + property(pom, "version"),
                        "<classifier>driver-tests</classifier>",
                        "<version>" + property(pom, "junit.version"));
    }

    /** Returns the text of the first element of a name. */
    private static String property(String pom, String name) {
        return pom.replaceFirst("(?s).*?<" + name + ">(.*?)<.*", "$1");
    }

    @Test
    void noClassInItNeedsAClassThatIsNot() {
        List<JavaClass> classes =
                new ClassFileImporter().importPath(jar).stream().toList();
        Set<String> names = classes.stream().map(JavaClass::getName).collect(Collectors.toSet());
        Set<String> missing = classes.stream()
                .flatMap(type -> type.getDirectDependenciesFromSelf().stream())
                .map(Dependency::getTargetClass)
                .map(type -> type.getBaseComponentType().getName())
                .filter(name -> name.contains(".") && !names.contains(name))
                .filter(name -> !LIBRARY.matcher(name).matches()
                        && !OPTIONAL.matcher(name).matches())
                .collect(Collectors.toCollection(TreeSet::new));
        assertThat(names).hasSizeGreaterThan(400);
        assertThat(missing).isEmpty();
    }

    @Test
    void theDriverTestKitNeedsOnlyThisJarAndJUnit() {
        Set<String> names = new ClassFileImporter()
                .importPath(jar).stream().map(JavaClass::getName).collect(Collectors.toSet());
        Set<String> missing = new ClassFileImporter()
                .importPath(CLASSES.resolveSibling("test-classes").resolve("majic/drivertest")).stream()
                        .flatMap(type -> type.getDirectDependenciesFromSelf().stream())
                        .map(type ->
                                type.getTargetClass().getBaseComponentType().getName())
                        .filter(name -> name.contains(".") && !names.contains(name))
                        .filter(name -> !name.startsWith("majic.drivertest.")
                                && !name.startsWith("org.junit.jupiter.")
                                && !LIBRARY.matcher(name).matches())
                        .collect(Collectors.toCollection(TreeSet::new));
        assertThat(missing).isEmpty();
    }

    @Test
    void aRobotThatSpeaksRosNamesTheLibrariesThatItMisses() throws Exception {
        URL[] onlyTheJar = {jar.toUri().toURL()};
        try (URLClassLoader alone = new URLClassLoader(onlyTheJar, ClassLoader.getPlatformClassLoader())) {
            Constructor<?> driver = alone.loadClass("majic.ros.MajicRos").getConstructor(String.class);

            assertThatThrownBy(() -> driver.newInstance("ros://10.0.0.5"))
                    .cause()
                    .hasMessage("robots that speak ROS need the libraries jackson-databind and jackson-dataformat-cbor:"
                            + " add both to the class path");
        }
    }

    @Test
    void aTeamCommandedInMajicScriptNeedsNothingElse() throws Exception {
        Files.copy(
                CLASSES.resolveSibling("test-classes").resolve("TwentyLines.class"), jar.resolve("TwentyLines.class"));
        try (SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1)) {
            assertThat(run("TwentyLines", "add " + lab.address("pioneer").orElseThrow(), "1 move 20", "acts"))
                    .contains("1 move 20: done", "WanderDog");
        }
    }

    @Test
    void buildingAMapWithoutItsLibraryIsRefusedWithItsName() throws Exception {
        Files.copy(
                CLASSES.resolveSibling("test-classes").resolve("TwentyLines.class"),
                jar.resolve("TwentyLines.class"),
                StandardCopyOption.REPLACE_EXISTING);
        try (SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1)) {
            assertThat(run("TwentyLines", "add " + lab.address("pioneer").orElseThrow(), "map start 1", "1 get x"))
                    .contains("map start: the library EJML is missing", "1 x = ");
        }
    }

    private String run(String... program) throws Exception {
        String libraries = Stream.of(
                        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"))
                                .split(Pattern.quote(File.pathSeparator)))
                .filter(file -> file.contains("jSerialComm") || file.contains("jspecify"))
                .collect(Collectors.joining(File.pathSeparator));
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                jar + File.pathSeparator + libraries));
        command.addAll(List.of(program));
        Process embedding =
                new ProcessBuilder(command).redirectErrorStream(true).start();
        String printed = new String(embedding.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(embedding.waitFor()).isZero();
        return printed;
    }
}
