package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import majic.act.MajicAct;
import majic.act.Role;
import majic.act.make.JavaSource;
import majic.bot.BotAddress;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests the Java on the pages of the documentation. A block is a class, the body of a method, methods of an act, or
 * lines of an example. The line number of a failure is that on the page.
 */
@Tag("jdk")
class JavaOnPagesTest {
    private static final Pattern CLASS = Pattern.compile("(?m)^public (?:final )?class (\\w+)");
    private static final Pattern ADDRESS = Pattern.compile("\\(\"(pioneer|hemisson):.*?\"\\)");
    private static final String IMPORTS = Stream.of(
                    "act",
                    "act.file",
                    "act.make",
                    "aibo",
                    "bot",
                    "environment",
                    "hemisson",
                    "mavlink",
                    "pioneer",
                    "ros")
            .map(name -> "import majic." + name + ".*; ")
            .reduce("import java.util.*; import java.nio.file.*; ", String::concat);

    /** The names that the pages explain in words, and that their code uses. */
    private static final String METHOD = "public class Fragment { static boolean userAgrees(List<String> text) {"
            + " return true; } public static void run(BotEnvironment environment,"
            + " majic.bot.BotAddress address, Settings settings, Path path,"
            + " majicsim.Lab lab) throws Exception { ";

    private static final String ACT = "public class Fragment extends MajicAct { @Override protected void behave() {} ";

    @TempDir
    private Path folder;

    static Stream<Page.Code> blocks() {
        return Page.all().stream().flatMap(page -> page.blocks("java"));
    }

    static Stream<Page.Code> robots() {
        return blocks().filter(block -> ADDRESS.matcher(block.text()).find());
    }

    @ParameterizedTest
    @MethodSource("blocks")
    void everyBlockCompilesOrIsPartOfAnExample(Page.Code block) throws IOException {
        assertThat(isInAnExample(block) || compile(block, block.text()) != null).isTrue();
    }

    @ParameterizedTest
    @MethodSource("robots")
    void everyProgramForARobotMovesIt(Page.Code block) throws Exception {
        Matcher address = ADDRESS.matcher(block.text());
        assertThat(address.find()).isTrue();
        String type = address.group(1);
        try (LabRig rig = LabRig.exact()) {
            majic.bot.Pose start = rig.truePose(type);
            compile(block, address.replaceAll("(address, environment)"))
                    .getMethod(
                            "run",
                            BotEnvironment.class,
                            BotAddress.class,
                            Settings.class,
                            Path.class,
                            majicsim.Lab.class)
                    .invoke(
                            null,
                            new BotEnvironment(rig.lab().time(), Settings.inMemory()),
                            rig.lab().address(type).orElseThrow(),
                            null,
                            null,
                            null);
            assertThat(rig.truePose(type)).isNotEqualTo(start);
        }
    }

    @Test
    void theRolesOfTheGuideAreWrittenAsItStates() throws Exception {
        Page page = Page.of("docs/programmers-guide.md");
        Page.Code block = page.block("java", "List<Role> roles()");
        MajicAct act = (MajicAct) compile(block, block.text()).getConstructor().newInstance();
        assertThat(page.text())
                .contains("is written as `"
                        + String.join(
                                "; ", act.roles().stream().map(Role::toString).toList()) + "`");
    }

    /** Compares with the examples, without layout and comments. */
    private static boolean isInAnExample(Page.Code block) throws IOException {
        try (Stream<Path> examples = Files.list(Path.of("examples"))) {
            for (Path example : examples.filter(Files::isRegularFile).toList()) {
                if (bare(Files.readString(example)).contains(bare(block.text()))) {
                    return true;
                }
            }
            return false;
        }
    }

    private static String bare(String code) {
        return code.replaceAll(" +//.*", "").replaceAll("\\s+", " ");
    }

    /** Compiles a block, or another text of as many lines in its place. */
    private Class<?> compile(Page.Code block, String text) throws IOException {
        Matcher whole = CLASS.matcher(text);
        String name = whole.find() ? whole.group(1) : "Fragment";
        String source = name.equals("Fragment") ? surrounded(text) : text;
        Path file = folder.resolve(name + ".java");
        Files.writeString(file, "\n".repeat(block.line() - 2) + (name.equals("Fragment") ? source : "\n" + source));
        return new Compiled(JavaSource.compile(file)).load(name);
    }

    private static String surrounded(String text) {
        boolean isMethod = text.startsWith("@Override");
        return IMPORTS + (isMethod ? ACT : METHOD) + "\n" + text + (isMethod ? "}" : "}}");
    }

    private static final class Compiled extends ClassLoader {
        private final Map<String, byte[]> classes;

        Compiled(Map<String, byte[]> classes) {
            this.classes = classes;
        }

        Class<?> load(String name) {
            try {
                return loadClass(name);
            } catch (ClassNotFoundException e) {
                throw new AssertionError(e);
            }
        }

        @Override
        protected Class<?> findClass(String name) throws ClassNotFoundException {
            byte[] bytes = classes.get(name);
            if (bytes == null) {
                throw new ClassNotFoundException(name);
            }
            return defineClass(name, bytes, 0, bytes.length);
        }
    }
}
