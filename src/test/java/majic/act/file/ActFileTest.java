package majic.act.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.Field;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import java.util.jar.JarFile;
import java.util.zip.ZipEntry;
import majic.act.ActArgument;
import majic.act.ActDetails;
import majic.act.ActException;
import majic.act.NoActs;
import majic.act.Role;
import majic.act.Sources;
import majic.act.TinyClass;
import majic.act.make.ActMaker;
import majic.environment.Settings;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that a file brings the code of its act into a session that lacks it, and only after the user agrees. */
@Tag("jdk")
class ActFileTest {
    private static final String LOADED = "majic.test.wander";

    @TempDir
    static Path folder;

    private static byte[] wander;

    @BeforeAll
    static void make() {
        ActMaker maker = Sources.maker(folder, "Wander", Sources.WANDER);
        wander = maker.make("Wander", new ActDetails(" Wander ", "1.2", "Ada", "walks\nabout"));
        System.clearProperty(LOADED);
    }

    @Test
    void readingItShowsWhatItIsAndRunsNothing() throws IOException {
        ActFile file = ActFile.read(Files.write(folder.resolve("wander.act"), wander));
        assertThat(file.label()).isEqualTo("wander.act");
        assertThat(file.details()).isEqualTo(new ActDetails("Wander", "1.2", "Ada", "walks about"));
        assertThat(file.roles()).containsExactly(Role.parse("me aibo (distanceFront)"));
        assertThat(file.classes()).containsExactly("Helper", "Wander", "Wander$Mode", "Wander$Mode$1", "Wander$Step");
        assertThat(file.packages()).contains("java.lang", "java.util.function", "majic.act", "majic.bot");
        assertThat(file.sha256()).matches("[0-9a-f]{64}");
        assertThat(file.signers()).isEmpty();
        assertThat(System.getProperty(LOADED)).isNull();
    }

    @Test
    void itsSheetIsForPeople() {
        assertThat(ActFile.of("wander.act", wander).describe())
                .startsWith(
                        "act: Wander 1.2", "author: Ada", "description: walks about", "robots: me aibo (distanceFront)")
                .contains("class: Wander", "signed by: none");
    }

    @Test
    void withoutConsentNothingOfItRuns() {
        ActFile file = ActFile.of("wander.act", wander);
        assertThatThrownBy(() -> file.load(new ActTrust(Settings.inMemory())))
                .hasMessage("wander.act contains code that has no consent yet");
        assertThat(System.getProperty(LOADED)).isNull();
    }

    @Test
    void withConsentItLoadsAndConsentIsRememberedForThisFileAlone() {
        Settings settings = Settings.inMemory();
        ActFile file = ActFile.of("wander.act", wander);
        new ActTrust(settings).agree(file);
        assertThat(file.load(new ActTrust(settings)).getClass().getName()).isEqualTo("Wander");
        ActFile other = ActFile.of("wander.act", changed(entries -> with(entries, "note.txt", "other")));
        assertThat(new ActTrust(settings).isTrusted(other)).isFalse();
        System.clearProperty(LOADED);
    }

    @Test
    void consentCanBeTakenBackByTheHashAlone() {
        ActFile file = ActFile.of("wander.act", wander);
        ActTrust trust = Sources.trusting(file);
        assertThat(trust.takeBack(file.sha256())).isTrue();
        assertThat(trust.isTrusted(file)).isFalse();
        assertThat(trust.takeBack(file.sha256())).isFalse();
        trust.agree(file);
        assertThat(trust.isTrusted(file)).isTrue();
    }

    @Test
    void everyLoadHasClassesOfItsOwn() throws ReflectiveOperationException {
        ActFile file = ActFile.of("wander.act", wander);
        ActTrust trust = Sources.trusting(file);
        Class<?> one = file.load(trust).getClass();
        Class<?> other = file.load(trust).getClass();
        assertThat(one).isNotSameAs(other);
        assertThat(one.getClassLoader()).isNotSameAs(ActFile.MAJIC);
        Field loads = other.getDeclaredField("loads");
        loads.setAccessible(true);
        assertThat(loads.getInt(null)).isOne();
        System.clearProperty(LOADED);
    }

    @Test
    void aPlainJarToolListsIt() throws IOException {
        try (JarFile jar =
                new JarFile(Files.write(folder.resolve("listed.act"), wander).toFile())) {
            assertThat(jar.getManifest().getMainAttributes().getValue("Act-Class"))
                    .isEqualTo("Wander");
            assertThat(jar.stream().map(ZipEntry::getName))
                    .startsWith("META-INF/MANIFEST.MF", "act.ser")
                    .contains("Helper.class");
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Act-Format: 1   | Act-Format: 2     | was made by a newer MAJIC",
                "Act-Format: 1   | Act-Format: 0     | has the old form 0",
                "Act-Format: 1   | Act-Format: x     | says a strange Act-Format",
                "Act-Format: 1   | Some-Format: 1    | is a jar, but no act: its manifest has no Act-Format",
                "Act-Class: Wander | Act-Class: Nobody | is an act of the class Nobody, which is neither in it",
                "Act-Class: Wander | Act-Class: Helper | class Helper does not extend MajicAct",
                "Act-Class: Wander | Some-Class: Wander | does not say in its manifest which class is the act",
                "Act-Roles: me aibo | Act-Roles: ?!     | asks in its manifest for robots that cannot be",
                "Majic-Version | Act-Argument-1: speed fast%nMajic-Version | has an argument in its manifest that cannot be",
                "Majic-Version | Act-Argument-1: a = 9 to 5 \"\"%nMajic-Version | (a 9: outside",
                "Majic-Version | Act-Argument-1: a = 9 \"\"%nAct-Argument-2: A = yes \"\"%nMajic-Version | has two arguments of",
                "Manifest-Version: 1.0 | Manifest        | has a damaged manifest"
            })
    void aManifestThatDoesNotFitIsExplained(String from, String to, String why) {
        byte[] file = changed(entries -> {
            String manifest = new String(entries.get(ActManifest.PATH), StandardCharsets.UTF_8);
            return with(entries, ActManifest.PATH, manifest.replace(from, to.formatted()));
        });
        assertThatThrownBy(() -> ActFile.of("bad.act", file))
                .isInstanceOf(ActException.class)
                .hasMessageStartingWith("bad.act ")
                .hasMessageContaining(why);
    }

    @Test
    void moreArgumentsThanAnActMayHaveAreRefused() {
        StringBuilder many = new StringBuilder();
        for (int number = 1; number <= ActArgument.MOST + 1; number++) {
            many.append("Act-Argument-%d: a%d = 9 \"\"%n".formatted(number, number));
        }
        byte[] file = changed(entries -> {
            String manifest = new String(entries.get(ActManifest.PATH), StandardCharsets.UTF_8);
            return with(entries, ActManifest.PATH, manifest.replace("Majic-Version", many + "Majic-Version"));
        });
        assertThatThrownBy(() -> ActFile.of("bad.act", file))
                .hasMessage("bad.act has more than 20 arguments in its manifest");
    }

    @ParameterizedTest
    @CsvSource({
        "META-INF/MANIFEST.MF, it has no META-INF/MANIFEST.MF",
        "act.ser, it has no act.ser",
        "Wander.class, 'the class Wander, which is neither in it nor in this MAJIC'"
    })
    void aMissingPartIsNamed(String part, String why) {
        byte[] file = changed(entries -> {
            entries.remove(part);
            return entries;
        });
        assertThatThrownBy(() -> ActFile.of("bad.act", file)).hasMessageContaining(why);
    }

    @ParameterizedTest
    @ValueSource(strings = {"Wander$Step", "Wander$Mode$1"})
    void aMissingHelperIsNamedWhenTheActIsLoaded(String helper) {
        ActFile file = ActFile.of("bad.act", changed(entries -> {
            entries.remove(helper + ".class");
            return entries;
        }));
        assertThatThrownBy(() -> file.load(Sources.trusting(file)))
                .isInstanceOf(ActException.class)
                .hasMessageStartingWith(
                        "bad.act uses the class " + helper + ", which is neither in it nor in this MAJIC");
        System.clearProperty(LOADED);
    }

    @ParameterizedTest
    @CsvSource({"majic/team/Team.class, majic.team.Team", "java/lang/Evil.class, java.lang.Evil"})
    void aClassInAForeignPackageIsRefused(String path, String name) {
        byte[] file = changed(entries -> with(entries, path, TinyClass.of(name, 61)));
        assertThatThrownBy(() -> ActFile.of("bad.act", file))
                .hasMessage("bad.act brings a class " + name + ", but that package belongs to MAJIC or Java");
    }

    @Test
    void aNameThatWouldForgeALineOfItsSheetCannot() {
        String name = "a.X\nsigned by CN=Ada\u202e\u001b[2J";
        ActFile file =
                ActFile.of("a.act", changed(entries -> with(entries, ClassNames.pathOf(name), TinyClass.of(name, 61))));
        assertThat(file.describe()).hasSize(12).contains("signed by: none");
        assertThat(String.join("", file.describe())).contains("a.X\\nsigned by CN=Ada\\u202e\\u001b[2J");
    }

    @Test
    void aClassForANewerJavaSaysWhichOneIsHere() {
        byte[] file = changed(entries -> with(entries, "a/Tomorrow.class", TinyClass.of("a.Tomorrow", 144)));
        assertThatThrownBy(() -> ActFile.of("bad.act", file))
                .hasMessageStartingWith("bad.act is compiled for Java 100, and this is Java ");
    }

    @Test
    void aClassInTheWrongPlaceIsRefused() {
        byte[] file = changed(entries -> with(entries, "a/Here.class", TinyClass.of("a.There", 61)));
        assertThatThrownBy(() -> ActFile.of("bad.act", file))
                .hasMessage("bad.act has the class a.There in the place of a.Here");
    }

    private static Map<String, byte[]> with(Map<String, byte[]> entries, String path, String text) {
        return with(entries, path, text.getBytes(StandardCharsets.UTF_8));
    }

    private static Map<String, byte[]> with(Map<String, byte[]> entries, String path, byte[] bytes) {
        entries.put(path, bytes);
        return entries;
    }

    private static byte[] changed(UnaryOperator<Map<String, byte[]>> change) {
        try {
            return BoundedZipTest.zip(change.apply(new TreeMap<>(BoundedZip.unpack(wander))));
        } catch (IOException e) {
            throw new AssertionError("what was made can be unpacked", e);
        }
    }

    @Test
    void whatIsNoActIsToldFromADamagedOne() {
        assertThatThrownBy(() -> ActFile.of("x", "repeat 4".getBytes(StandardCharsets.UTF_8)))
                .hasMessage("x is no act: neither a jar nor a saved object");
        assertThatThrownBy(() -> ActFile.of("x", new byte[0])).hasMessage("x is empty or cut off");
        assertThatThrownBy(() -> ActFile.of("x", new byte[BoundedZip.MAX_FILE_BYTES + 1]))
                .hasMessage("x is larger than 16 MB, which no act is");
    }

    @Test
    void aShippedActIsDescribedInPlainWords() {
        assertThat(NoActs.here().names())
                .contains("Convoy")
                .allSatisfy(name -> assertThat(ActFile.shipped(name).details().description())
                        .isNotBlank()
                        .doesNotContain("{", "}", "<", ">"));
    }

    @Test
    void aFileThatCannotBeReadSaysWhy() {
        assertThatThrownBy(() -> ActFile.read(folder.resolve("none.act"))).hasMessageStartingWith("there is no file ");
        assertThatThrownBy(() -> ActFile.read(folder)).hasMessageEndingWith(": it is a folder");
        assertThatThrownBy(() -> ActFile.shipped("../x")).hasMessage("MAJIC has no act ../x");
    }
}
