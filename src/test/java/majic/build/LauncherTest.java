package majic.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import majic.tool.Tool;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the shell script that builds and starts MAJIC, with scripts in place of Maven and Java. */
@Tag("jdk")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has majic.cmd instead")
class LauncherTest {
    private static final String MAVEN =
            "#!/bin/sh\ncat >/dev/null\nmkfifo target/archive\ntouch target/majic.jar\necho BUILD SUCCESS\n";

    @TempDir
    Path folder;

    private Path clone;

    @BeforeEach
    void copyTheLauncher() throws IOException {
        copyTheLauncher("clone");
    }

    private void copyTheLauncher(String name) throws IOException {
        clone = folder.resolve(name);
        Files.createDirectories(clone.resolve("config"));
        Files.createDirectories(clone.resolve("src/main"));
        Files.createDirectories(clone.resolve("sims"));
        Files.createFile(clone.resolve("pom.xml"));
        Files.copy(Path.of("config/tools.sh"), clone.resolve("config/tools.sh"));
        program("majic", Files.readString(Path.of("majic")));
    }

    @Test
    void theInputOfThePipeReachesMajicAlthoughMavenReadsItsInput() throws Exception {
        java("", "echo \"started with $*\"; cat");

        String said = start("2 move 1000\nquit\n", "--lab", "--console");

        assertThat(said).contains("--lab --console\n2 move 1000\nquit\n");
    }

    @Test
    void aLinkToTheLauncherStartsTheSameClone() throws Exception {
        java("", "echo started; cat");
        Path near = Files.createSymbolicLink(clone.resolve("link"), Path.of("majic"));
        Path far = Files.createSymbolicLink(folder.resolve("majic-link"), near);

        assertThat(start(far, "")).contains("started");
    }

    @Test
    void theLibraryThatAriasWrapperNeedsIsFoundInAriasFolder() throws Exception {
        Path lib = Files.createDirectories(folder.resolve("Aria/lib"));
        Files.createFile(lib.resolve("libAria.so"));
        java("", "echo \"libraries in $LD_LIBRARY_PATH\"");

        assertThat(start("", "--aria-home", "" + lib.getParent())).contains("libraries in " + lib.toRealPath());
        assertThat(start("", "--aria-home=" + lib.getParent())).contains("libraries in " + lib.toRealPath());
        assertThat(start("", "--lab")).doesNotContain("" + lib);
    }

    @Test
    void javaAsksForTheKeysOfTheDisplayEveryTenMillisecondsSoThatF12DoesNotWait() throws Exception {
        java("", "echo \"asks every $_AWT_MAX_POLL_TIMEOUT ms\"");

        assertThat(start("")).contains("asks every 10 ms");
    }

    @Test
    void aPackageIsMadeByTheJdkInUse() throws Exception {
        java("", "echo \"java $*\"");
        program("bin/fakeroot", "#!/bin/sh\n");
        program("bin/objcopy", "#!/bin/sh\n");

        assertThat(start("", "package"))
                .endsWith("java -Djava.awt.headless=true -cp " + clone + "/target/majic.jar " + clone
                        + "/src/build/Packaging.java " + clone + "\n");
    }

    @Test
    void theEmbeddedBrokerIsFetchedOnce() throws Exception {
        java("", "ls target/broker");
        broker("mkdir \"$folder\"; touch \"$folder/broker.jar\"");

        assertThat(start("", "--broker"))
                .contains("fetching the embedded broker")
                .endsWith("broker.jar\n");
        assertThat(start("", "--broker")).doesNotContain("fetching").endsWith("broker.jar\n");
    }

    @Test
    void aFetchOfTheBrokerThatFailsHalfWayIsExplainedAndDoneAgain() throws Exception {
        java("", "ls target");
        broker(
                "mkdir \"$folder\"; touch \"$folder/half\"; echo '[ERROR] Failed to execute goal: Could not transfer artifact"
                        + " a:b:jar:1 from/to central (https://repo.example.org/maven2): Connection reset -> [Help 1]'; exit 1");
        assertThat(start("", "--broker"))
                .contains(
                        "the embedded broker was not fetched: https://repo.example.org/maven2: Connection reset; start MAJIC"
                                + " again to try again")
                .doesNotContain("broker\n");

        java("", "ls target/broker");
        broker("mkdir \"$folder\"; touch \"$folder/broker.jar\"");
        assertThat(start("", "--broker")).contains("fetching").endsWith("\nbroker.jar\n");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "transfer failed for https://repo.example.org/maven2/a.pom @ line 57, column 19: PKIX path building failed:"
                        + " sun.security.provider.certpath.SunCertPathBuilderException: unable to find valid certification path"
                        + " | PKIX path building failed: unable to find valid certification path; Java does not trust the"
                        + " certificate, perhaps that of a proxy: get it from the proxy's owner and type keytool"
                        + " -importcert -cacerts -file CERTIFICATE",
                "repo.example.org: Name or service not known | repo.example.org: Name or service not known"
            })
    void aLibraryThatCannotBeFetchedIsExplainedWithItsReason(String printed, String reason) throws Exception {
        String said = "[ERROR] Non-resolvable import POM: Could not transfer artifact a:b:pom:1 from/to central"
                + " (https://repo.example.org/maven2): ";
        program(
                "bin/mvn",
                "#!/bin/sh\necho '" + said + "transfer failed @ line 57, column 19'\necho '" + said + printed
                        + " -> [Help 2]'\n");
        program("bin/javac", "#!/bin/sh\n");
        program("bin/java", "#!/bin/sh\necho 'openjdk version \"17.0.1\"' >&2\n");

        assertThat(start(""))
                .contains("majic: a library cannot be fetched: https://repo.example.org/maven2: " + reason + "\n")
                .doesNotContain("[ERROR]");
    }

    @Test
    void theInstallationOfPackagesStatesItsSizeItsProgressAndItsProblem() throws Exception {
        program("bin/apt-get", """
                #!/bin/sh
                case "$*" in
                    *--assume-no*) echo "Need to get 230 MB of archives." ;;
                    *Status-Fd*) printf '%s\\n' dlstatus:1:1.5:java dlstatus:2:30.1:java pmstatus:java:99.9:java \
                            "E: no space left: /usr"; exit 100 ;;
                esac
                """);
        String script = "PATH=%s/bin:$PATH; . config/tools.sh; as_root() { \"$@\"; }; may_install() { :; }\n"
                + "install_or_name 'a JDK' default-jdk 2>&1";

        assertThat(Tool.run("sh", "-c", script.formatted(clone))).isEqualTo("""
                        majic: a JDK is missing; installing default-jdk
                        majic: 230 MB to fetch; this can take minutes
                        majic: fetching, 1 %
                        majic: fetching, 30 %
                        majic: installing, 99 %
                        majic: apt-get: no space left: /usr
                        majic: installing failed; try: apt-get update && apt-get install default-jdk
                        """);
    }

    /** Creates a Maven that does this when the broker is fetched, into {@code $folder}. */
    private void broker(String fetching) throws IOException {
        program(
                "bin/mvn",
                MAVEN.replace(
                        "#!/bin/sh\n",
                        "#!/bin/sh\ncase \"$*\" in *-Dmajic.broker=*) folder=${7#-Dmajic.broker=}; " + fetching
                                + "; exit ;; esac\n"));
    }

    @Test
    void eachCloneHasAnArchiveOfItsOwn() throws Exception {
        String first = archiveName();
        assertThat(archiveName()).isEqualTo(first);

        copyTheLauncher("other clone");
        assertThat(archiveName()).startsWith("majic-17-").endsWith(".jsa").isNotEqualTo(first);
    }

    /** Starts the program and returns the name of the class-data archive that is made for its next start. */
    private String archiveName() throws Exception {
        java("echo \"$1\" >target/archive", "cat target/archive");
        String option = start("").lines().reduce((one, next) -> next).orElseThrow();
        String file = option.substring(option.lastIndexOf('/') + 1);
        return file.substring(0, file.lastIndexOf('.'));
    }

    /**
     * Creates the program's Java, which does this when it makes the archive of class data, and when it starts MAJIC.
     */
    private void java(String classData, String start) throws IOException {
        program("bin/mvn", MAVEN);
        program("bin/javac", "#!/bin/sh\n");
        program(
                "bin/java",
                "#!/bin/sh\ncd '" + clone + "'\ncase \"$*\" in\n"
                        + "-version) cat >/dev/null; echo 'openjdk version \"17.0.1\"' >&2 ;;\n"
                        + "*class-data) " + classData + " ;;\n"
                        + "*) " + start + " ;;\nesac\n");
    }

    private String start(String input, String... arguments) throws Exception {
        return start(clone.resolve("majic"), input, arguments);
    }

    private String start(Path program, String input, String... arguments) throws Exception {
        ProcessBuilder launcher = new ProcessBuilder(program.toString());
        launcher.command().addAll(List.of(arguments));
        launcher.redirectErrorStream(true);
        launcher.environment().put("JAVA_HOME", clone.toString());
        launcher.environment().put("XDG_CACHE_HOME", folder.resolve("cache").toString());
        launcher.environment().put("PATH", clone.resolve("bin") + ":" + System.getenv("PATH"));
        Process process = launcher.start();
        try (OutputStream in = process.getOutputStream()) {
            in.write(input.getBytes(StandardCharsets.UTF_8));
        }
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        process.waitFor();
        return said;
    }

    private void program(String name, String text) throws IOException {
        Path file = clone.resolve(name);
        Files.createDirectories(file.getParent());
        // A program that still runs in the background cannot be written to, but it can be replaced.
        Files.deleteIfExists(file);
        Files.writeString(file, text);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--broker | fetched",
                "--broker lab | fetched",
                "--broker 127.0.0.1:1884 | fetched",
                "--broker=localhost:1884 | fetched",
                "--broker --listen 0.0.0.0:7000 | fetched",
                "MAJIC_MQTT_USER=anna MAJIC_MQTT_PASSWORD=secret --broker 0.0.0.0 | fetched",
                "MAJIC_MQTT_USER=anna --broker 0.0.0.0 | ''",
                "--broker 0.0.0.0 | ''",
                "--broker=0.0.0.0:1883 | ''",
                "--lab | ''"
            })
    void theBrokerIsFetchedOnlyForAnAddressThatWillBeAccepted(String words, String output) throws Exception {
        String script = """
                unset MAJIC_MQTT_USER MAJIC_MQTT_PASSWORD
                . config/tools.sh
                fetch_broker() { echo fetched; }
                for word in %s; do
                    case $word in MAJIC_*) export "$word" ;; *) set -- "$@" "$word" ;; esac
                done
                fetch_wanted_broker here "$@"
                """;
        assertThat(Tool.run("sh", "-c", script.formatted(words)).strip()).isEqualTo(output);
    }
}
