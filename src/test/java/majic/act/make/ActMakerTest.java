package majic.act.make;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TimeZone;
import java.util.TreeMap;
import majic.act.ActDetails;
import majic.act.ActException;
import majic.act.Sources;
import majic.act.TinyClass;
import majic.act.file.ActFile;
import majic.act.file.BoundedZip;
import majic.act.file.BoundedZipTest;
import majic.act.file.ClassNames;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests making acts from a source, a class file, a folder or a jar, and the errors for unsuitable classes. */
@Tag("jdk")
class ActMakerTest {
    private static final ActDetails DETAILS = ActDetails.named("Wander");

    @TempDir
    Path folder;

    @TempDir
    static Path sources;

    private static Path source;
    private static Map<String, byte[]> all;

    private final Map<String, byte[]> compiled = new TreeMap<>(all);

    @BeforeAll
    static void compile() throws IOException {
        source = Files.writeString(sources.resolve("Wander.java"), "package far.away;\n" + Sources.WANDER);
        all = JavaSource.compile(source);
    }

    /** The compiled classes in the folders of their packages. */
    private Path unpacked() throws IOException {
        Path root = folder.resolve("classes");
        for (Map.Entry<String, byte[]> one : compiled.entrySet()) {
            Path file = root.resolve(ClassNames.pathOf(one.getKey()));
            Files.createDirectories(file.getParent());
            Files.write(file, one.getValue());
        }
        return root;
    }

    @ParameterizedTest
    @ValueSource(strings = {"UTC", "Asia/Tokyo", "America/Los_Angeles"})
    void theFileContainsNoTimeThatDependsOnTheTimeZone(String zone) throws IOException {
        TimeZone before = TimeZone.getDefault();
        try {
            TimeZone.setDefault(TimeZone.getTimeZone(zone));
            byte[] here = ActMaker.from(source).make("far.away.Wander", DETAILS);
            TimeZone.setDefault(TimeZone.getTimeZone("Australia/Sydney"));
            assertThat(ActMaker.from(source).make("far.away.Wander", DETAILS)).isEqualTo(here);
        } finally {
            TimeZone.setDefault(before);
        }
    }

    @Test
    void aClassFileAFolderAndAJarMakeTheSameFileAsTheSource() throws IOException {
        byte[] fromSource = ActMaker.from(source).make("far.away.Wander", DETAILS);
        Path classes = unpacked();
        Map<String, byte[]> entries = new TreeMap<>();
        compiled.forEach((name, bytes) -> entries.put(ClassNames.pathOf(name), bytes));
        Path jar = Files.write(folder.resolve("wander.jar"), BoundedZipTest.zip(entries));
        for (Path given : new Path[] {classes.resolve("far/away/Wander.class"), classes, jar}) {
            ActMaker maker = ActMaker.from(given);
            assertThat(maker.onlyAct()).isEqualTo("far.away.Wander");
            assertThat(maker.make(maker.onlyAct(), DETAILS)).isEqualTo(fromSource);
        }
    }

    @Test
    void whatTheActDoesNotUseStaysOutside() throws IOException {
        compiled.put("far.away.Unused", TinyClass.of("far.away.Unused", 61));
        ActMaker maker = ActMaker.from(unpacked());
        ActFile file = ActFile.of("wander.act", maker.make("far.away.Wander", DETAILS));
        assertThat(file.classes()).contains("far.away.Helper").doesNotContain("far.away.Unused");
    }

    @Test
    void whatLiesBesideItsClassesIsPackedAndRead() throws Exception {
        Path reader = Files.writeString(folder.resolve("Reader.java"), """
                package far.away;
                public class Reader extends majic.act.MajicAct {
                    private final String words;
                    public Reader() throws java.io.IOException {
                        try (var in = getClass().getResourceAsStream("words.txt")) {
                            words = new String(in.readAllBytes());
                        }
                    }
                    protected void behave() { say(words); }
                }
                """);
        compiled.putAll(JavaSource.compile(reader));
        Path root = unpacked();
        Files.writeString(root.resolve("far/away/words.txt"), "hello");
        Files.writeString(root.resolve("far/away/Reader.java"), "a source");
        Files.writeString(root.resolve("far/elsewhere.txt"), "not of its package");
        ActFile file = ActFile.of("reader.act", ActMaker.from(root).make("far.away.Reader", DETAILS));
        assertThat(file.resources()).containsExactly("far/away/words.txt");
        assertThat(file.describe()).contains("other files in it: far/away/words.txt");
        Class<?> loaded = file.load(Sources.trusting(file)).getClass();
        assertThat(loaded.getResourceAsStream("words.txt")).hasContent("hello");
    }

    @Test
    void aFileBesideItThatIsTooLargeIsNamed() throws IOException {
        Path root = unpacked();
        Files.write(root.resolve("far/away/map.bin"), new byte[BoundedZip.MAX_ENTRY_BYTES + 1]);
        ActMaker maker = ActMaker.from(root);
        assertThatThrownBy(() -> maker.make("far.away.Wander", DETAILS))
                .hasMessage(
                        "far.away.Wander has beside it the file map.bin, which is larger than 4 MB; move it elsewhere");
    }

    @Test
    void aClassThatIsMissingIsNamedWithItsUser() throws IOException {
        compiled.remove("far.away.Helper");
        ActMaker maker = ActMaker.from(unpacked());
        assertThatThrownBy(() -> maker.make("far.away.Wander", DETAILS))
                .isInstanceOf(ActException.class)
                .hasMessage("far.away.Wander has the class far.away.Wander, which uses far.away.Helper;"
                        + " that is neither with it nor in MAJIC or Java");
    }

    @Test
    void aClassFileOutsideTheFolderOfItsPackageIsSentThere() throws IOException {
        Path astray = Files.write(folder.resolve("Wander.class"), compiled.get("far.away.Wander"));
        assertThatThrownBy(() -> ActMaker.from(astray))
                .hasMessage("Wander.class is the class far.away.Wander; its place is far/away/Wander.class");
    }

    @Test
    void amongSeveralActsOneIsChosen() {
        ActMaker maker = Sources.maker(folder, "Two", """
                import majic.act.MajicAct;
                class One extends MajicAct { protected void behave() {} }
                class Two extends One {}
                abstract class Half extends MajicAct {}
                """);
        assertThat(maker.acts()).containsExactly("One", "Two");
        assertThatThrownBy(maker::onlyAct).hasMessage("Two.java has several acts; choose one of One, Two");
        ActFile file = ActFile.of("two.act", maker.make("Two", ActDetails.named("Two")));
        assertThat(file.load(Sources.trusting(file)).getClass().getName()).isEqualTo("Two");
    }

    @Test
    void aSourceThatDoesNotCompileSaysWhere() {
        assertThatThrownBy(() -> Sources.maker(folder, "Bad", "class Bad {\n int x = y;\n int z = y; }"))
                .isInstanceOf(ActException.class)
                .hasMessageStartingWith("Bad.java cannot be compiled: line 2: cannot find symbol")
                .hasMessageEndingWith("(and 1 more)");
    }

    @Test
    void withoutACompilerItSaysWhatToDo() {
        assertThatThrownBy(() -> JavaSource.compile(source, null))
                .hasMessage("this Java has no compiler; install a JDK, or compile Wander.java elsewhere"
                        + " and give the class file");
    }

    @Test
    void whatIsNotThereOrNoCodeIsSaid() throws IOException {
        assertThatThrownBy(() -> ActMaker.from(folder.resolve("none.jar"))).hasMessageStartingWith("there is no file ");
        assertThatThrownBy(() -> ActMaker.from(folder.resolve("None.java")))
                .hasMessageStartingWith("there is no file ");
        Path text = Files.writeString(folder.resolve("Text.class"), "hello, this is text");
        assertThatThrownBy(() -> ActMaker.from(text)).hasMessage("Text.class is not a class file");
        Path empty = Files.createDirectory(folder.resolve("empty"));
        assertThatThrownBy(() -> ActMaker.from(empty).onlyAct())
                .hasMessage("empty has no act: none of its classes extends MajicAct");
    }

    /** Tests sources of a class Act, given without the imports. */
    @ParameterizedTest(name = "{1}")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "class Act {} | no act: it does not extend MajicAct",
                "interface Act {} | no act: it does not extend MajicAct",
                "abstract class Act extends MajicAct {} | is abstract; an act has to be complete",
                "class Outer { class Act extends MajicAct { protected void behave() {} } } | is an inner class; make it static",
                "class Outer { Object o() { class Act extends MajicAct { protected void behave() {} } return new Act(); } }"
                        + " | is declared inside a method; give it a file of its own",
            })
    void aClassThatCannotBeAnActIsToldWhy(String source, String why) {
        ActMaker maker = Sources.maker(folder, "Act", "import majic.act.MajicAct;\n" + source);
        assertThat(maker.acts()).isEmpty();
        assertThatThrownBy(maker::onlyAct).isInstanceOf(ActException.class).hasMessageContaining(why);
    }

    /** Tests bodies of a class Act. */
    @ParameterizedTest(name = "{1}")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "Act(int x) {} | Act has no constructor without arguments; give it one",
                "int x = 1 / (int) (0 * Math.random()); | Act failed in its constructor, where it has no robot yet:",
                "{ bot.move(1); } | Act failed in its constructor, where it has no robot yet:",
                "static int x = Integer.parseInt(`x`.trim()); | Act failed in its static initialiser:",
                "Object out = new Object(); | its field 'out' holds a java.lang.Object, which cannot be saved",
                "Thread thread = new Thread(); | its field 'thread' holds a java.lang.Thread, which cannot be saved",
                "java.net.InetSocketAddress to = new java.net.InetSocketAddress(80);"
                        + " | its field 'to' holds a java.net.InetSocketAddress, which no act may hold",
                "Helper helper = new Helper(); static class Helper {} | its field 'helper' holds a Act$Helper",
                "Runnable run = () -> {}; | its field 'run' holds a Act$$Lambda",
                "Runnable run = (Runnable & java.io.Serializable) () -> {};"
                        + " | its field 'run' holds a java.lang.invoke.SerializedLambda",
                "java.util.List<Object> list = new java.util.ArrayList<>(); { list.add(list); }"
                        + " | its field 'list' holds a collection that holds itself",
                "public java.util.List<majic.act.Role> roles() { return java.util.List.of(); } | asks for no robot",
                "public java.util.List<majic.act.Role> roles() { return null; } | failed in its roles()",
                "public java.util.List<majic.act.Role> roles() { var me = majic.act.Role.any(`me`);"
                        + " return java.util.List.of(me, me); } | for two robots of the name me",
                "Object lab() { return majicsim.Lab.class; } | uses majicsim.Lab; that belongs to the simulated lab"
            })
    void anActThatCannotBeSavedIsToldWhy(String inside, String why) {
        ActMaker maker = Sources.maker(
                folder,
                "Act",
                "class Act extends majic.act.MajicAct { protected void behave() {} " + inside.replace('`', '"') + " }");
        assertThatThrownBy(() -> maker.make("Act", ActDetails.named("Act")))
                .isInstanceOf(ActException.class)
                .hasMessageStartingWith("Act ")
                .hasMessageContaining(why);
    }

    @Test
    void aTransientFieldMayHoldAnything() {
        byte[] file = Sources.act(folder, "Act", """
                class Act extends majic.act.MajicAct {
                    private transient Thread helper = new Thread();
                    protected void behave() {}
                }
                """);
        assertThat(ActFile.of("act.act", file).classes()).containsExactly("Act");
    }

    @Test
    void anObjectOfAnInnerClassIsSavedWithItsAct() throws ReflectiveOperationException {
        ActFile file = ActFile.of("act.act", Sources.act(folder, "Act", """
                class Act extends majic.act.MajicAct {
                    final Step step = new Step();
                    class Step implements java.io.Serializable { Act act() { return Act.this; } }
                    protected void behave() {}
                    public String toString() { return String.valueOf(step.act() == this); }
                }
                """));
        assertThat(file.load(Sources.trusting(file))).hasToString("true");
    }

    @Test
    void anActWithCodeMayHoldMuchData() {
        ActFile file = ActFile.of("act.act", Sources.act(folder, "Act", """
                class Act extends majic.act.MajicAct {
                    final java.util.List<String> words = new java.util.ArrayList<>();
                    { for (int i = 0; i < 20_000; i++) { words.add("word " + i); } }
                    protected void behave() {}
                    public String toString() { return words.size() + " words"; }
                }
                """));
        assertThat(file.load(Sources.trusting(file))).hasToString("20000 words");
    }

    @Test
    void aPackageOfMajicsIsNotForActs() {
        ActMaker maker = Sources.maker(folder, "Act", """
                package majic.mine;
                class Act extends majic.act.MajicAct { protected void behave() {} }
                """);
        assertThatThrownBy(maker::onlyAct)
                .hasMessage("Act.java has no act: majic.mine.Act is in the package majic.mine, which belongs to MAJIC;"
                        + " choose another");
    }
}
