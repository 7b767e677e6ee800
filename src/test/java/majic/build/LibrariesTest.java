package majic.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Element;

/**
 * Compares the libraries beside MAJIC's jar with the list in it, {@code META-INF/LIBRARIES.txt}, which makes each new
 * library, version and licence visible in the commit that brings it. Running this test with
 * {@code -Dlibraries.write=true} writes the list anew.
 */
class LibrariesTest {
    private static final Path LIST = Path.of("src/main/resources/META-INF/LIBRARIES.txt");
    private static final Pom MAJIC = Pom.read(Path.of("pom.xml"));

    /**
     * An artifact with a version of numbers, which Netty ends with a word: no range, no newest one, no preliminary one.
     */
    private static final Pattern FIXED = Pattern.compile("[\\w.-]+:\\d+(\\.\\d+)*(\\.Final)?");

    private static final String OWN_GROUP = "${project.groupId}";

    private static final Pattern PROPERTY = Pattern.compile("\\$\\{(.+)}");

    /** The words by which licences are recognised that allow MAJIC to be passed on with the library. */
    private static final Pattern PERMITTED = Pattern.compile("(?i).*(Apache|MIT|BSD).*");

    /** Where Maven binds a plug-in without being told; others are pinned where they are configured. */
    private static final List<String> OF_THE_LIFECYCLE =
            List.of("clean", "resources", "compiler", "surefire", "jar", "install", "deploy", "site");

    /**
     * A library beside the jar.
     *
     * @param name group and artifact
     * @param version its version
     * @param jar its file
     * @param repository the local repository it is in
     */
    private record Library(String name, String version, Path jar, Path repository) {
        Pom pom() {
            return Pom.read(Path.of(jar.toString().replaceFirst("\\.jar$", ".pom")));
        }

        List<String> licences() {
            return pom().licences(repository);
        }

        String line() {
            return name + " " + version + ": " + String.join(" or ", licences());
        }
    }

    @Test
    void theListInTheJarHasEveryLibraryWithItsVersionAndLicence() throws IOException {
        List<String> lines = new ArrayList<>(List.of(
                "The libraries that MAJIC comes with, and their licences. MAJIC itself: LICENSE, in this folder.", ""));
        libraries().values().forEach(library -> lines.add(library.line()));
        if (Boolean.getBoolean("libraries.write")) {
            Files.write(LIST, lines);
        }

        assertThat(lines)
                .as("after an intended change run mvn test -Dtest=LibrariesTest -Dlibraries.write=true")
                .isEqualTo(Files.readAllLines(LIST));
    }

    @Test
    void everyLibraryMayBePassedOnWithMajic() {
        assertThat(libraries().values())
                .allMatch(library -> library.licences().stream()
                        .anyMatch(licence -> PERMITTED.matcher(licence).matches()));
    }

    @Test
    void everyVersionInTheProjectFileIsFixed() {
        assertThat(Stream.of("dependency", "plugin", "path").flatMap(kind -> MAJIC.all(kind).stream()))
                .filteredOn(LibrariesTest::needsVersion)
                .extracting(one -> Pom.text(one, "artifactId") + ":" + version(one))
                .allMatch(one -> FIXED.matcher(one).matches());
    }

    @Test
    void everyPlugInOfTheLifecycleIsPinned() {
        assertThat(MAJIC.all("plugin").stream().map(plugin -> Pom.text(plugin, "artifactId")))
                .containsAll(OF_THE_LIFECYCLE.stream()
                        .map(name -> "maven-" + name + "-plugin")
                        .toList());
    }

    @Test
    void noLibraryAsksForARangeOfVersions() {
        assertThat(libraries().values())
                .flatMap(library -> library.pom().dependencies(false).toList())
                .noneMatch(one -> Pom.text(one, "version").matches(".*[\\[(,].*"));
    }

    private static boolean needsVersion(Element one) {
        return !Pom.text(one, "artifactId").isEmpty()
                && !Pom.text(one, "groupId").equals(OWN_GROUP)
                && !hasVersionElsewhere(one);
    }

    /** In the imported list of JUnit's artifacts, or where the plug-in is configured for every build. */
    private static boolean hasVersionElsewhere(Element one) {
        String artifact = Pom.text(one, "artifactId");
        return Pom.text(one, "version").isEmpty()
                && (Pom.text(one, "groupId").startsWith("org.junit")
                        || MAJIC.all("plugin").stream()
                                .anyMatch(other -> Pom.text(other, "artifactId").equals(artifact)
                                        && !Pom.text(other, "version").isEmpty()));
    }

    private static String version(Element one) {
        String version = Pom.text(one, "version");
        return PROPERTY.matcher(version)
                .replaceAll(found -> MAJIC.all(found.group(1)).get(0).getTextContent());
    }

    /** The libraries by name: those of the project file, and those that they need. */
    private static Map<String, Library> libraries() {
        Map<String, Library> libraries = new TreeMap<>();
        Deque<Library> open = new ArrayDeque<>();
        MAJIC.dependencies(true).flatMap(one -> library(one, "").stream()).forEach(open::add);
        while (!open.isEmpty()) {
            Library library = open.remove();
            if (libraries.putIfAbsent(library.name, library) == null) {
                String group = library.name.substring(0, library.name.indexOf(':'));
                library.pom()
                        .dependencies(false)
                        .filter(one -> !library.pom().isManagedForTests(one, library.repository))
                        .flatMap(one -> library(one, group).stream())
                        .forEach(open::add);
            }
        }
        return libraries;
    }

    private static Optional<Library> library(Element dependency, String ownGroup) {
        return library(
                Pom.text(dependency, "groupId").replace(OWN_GROUP, ownGroup), Pom.text(dependency, "artifactId"));
    }

    /** Empty if Maven has left it out. */
    private static Optional<Library> library(String group, String artifact) {
        Path folder = Path.of(group.replace('.', '/'), artifact);
        return Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
                .map(Path::of)
                .filter(jar ->
                        jar.getNameCount() > 2 && jar.getParent().getParent().endsWith(folder))
                .findFirst()
                .map(jar -> new Library(
                        group + ":" + artifact,
                        String.valueOf(jar.getParent().getFileName()),
                        jar,
                        jar.getRoot().resolve(jar.subpath(0, jar.getNameCount() - folder.getNameCount() - 2))));
    }
}
