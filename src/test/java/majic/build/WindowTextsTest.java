package majic.build;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.source.tree.AnnotationTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.LambdaExpressionTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.SourcePositions;
import com.sun.source.util.TreeScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.MessageFormat;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** All texts of windows stand in resource bundles, in English and in German; none is left in a class. */
class WindowTextsTest {
    private static final Path MAIN = Path.of("src/main");

    /** Packages whose classes show texts: the window and the panels of robots. */
    private static final Pattern WINDOWS = Pattern.compile("java/majic/(gui|panel|\\w+/panel)/.*\\.java");

    /** Constraints of MigLayout. */
    private static final Pattern LAYOUT = Pattern.compile(
            "(\\s*\\b(grow|push|wrap|span|split|skip|gap|al|align|width|height|w|h|wmin|wmax|hmin|hmax|hide|hidemode|"
                    + "dock|insets|ins|flow|fill|sizegroup|sg|sgx|cell|pad|shrink|nogrid|debug|growprio|spanx|spany|growx|growy|"
                    + "pushx|pushy|alignx|aligny|novisualpadding|gapx|gapy|gaptop|gapbottom|gapleft|gapright|pos|x|y|id|"
                    + "newline|noinvalid|nocache|fillx|filly|east|west|north|south)\\w*\\b[^,]*,?)+");

    /** Two words, or one that begins with a capital letter: what a user would read. */
    private static final Pattern WORDS =
            Pattern.compile("(?s).*\\p{L}{2,}[.,:;!?…]* \\p{L}+.*|\\W*\\p{Lu}\\p{Ll}+[ .:…]*");

    /** Keys as {@code KeyStroke} reads them. */
    private static final Pattern KEYS = Pattern.compile("((ctrl|shift|alt) )+[A-Z0-9_]*");

    /** A tag of HTML, which no user sees. */
    private static final Pattern TAG = Pattern.compile("<[^>]*>");

    /**
     * Calls whose arguments no user sees: names of threads, messages of the log, lines of MAJIC Script, patterns,
     * styles. The bodies of lambdas among them are looked at.
     */
    private static final Set<String> UNSEEN = Set.of(
            "answered",
            "background",
            "log",
            "submit",
            "propose",
            "compile",
            "matches",
            "replaceAll",
            "replaceFirst",
            "split",
            "thread",
            "putClientProperty",
            "getClientProperty",
            "addRule",
            "setProperty",
            "setName",
            "setFont",
            "firePropertyChange");

    /** Classes whose constructors' arguments no user sees. */
    private static final Set<String> UNSEEN_CLASSES = Set.of(
            "MigLayout", "Thread", "IllegalStateException", "IllegalArgumentException", "AssertionError", "Font");

    @TestFactory
    Stream<DynamicTest> germanHasTheTextsOfEnglishWithTheSameValues() throws IOException {
        return bundles().stream()
                .map(english -> DynamicTest.dynamicTest("" + MAIN.relativize(english), () -> {
                    Map<String, Integer> expected = placeholders(english);
                    assertThat(placeholders(english.resolveSibling("Texts_de.properties")))
                            .isNotEmpty()
                            .isEqualTo(expected);
                }));
    }

    /** Reads the number of values that each text takes; a pattern that cannot be read fails. */
    private static Map<String, Integer> placeholders(Path bundle) throws IOException {
        Map<String, Integer> counts = new TreeMap<>();
        read(bundle).forEach((key, text) -> {
            assertThat(text).as("the apostrophes of %s in %s", key, bundle).doesNotContainPattern("(?<!')'(?!')");
            counts.put(key, new MessageFormat(text).getFormatsByArgumentIndex().length);
        });
        return counts;
    }

    @TestFactory
    Stream<DynamicTest> classesUseTheTextsOfTheirBundle() throws IOException {
        return bundles().stream()
                .map(bundle -> DynamicTest.dynamicTest("" + MAIN.relativize(bundle), () -> {
                    Path folder = MAIN.resolve("java")
                            .resolve(MAIN.resolve("resources").relativize(bundle.getParent()));
                    Set<String> asked = new TreeSet<>();
                    Set<String> literals = new TreeSet<>();
                    for (Source source : parse(sources(folder, 1))) {
                        new KeyScanner(asked).scan(source.unit(), null);
                        new LiteralScanner(literals).scan(source.unit(), null);
                    }
                    assertThat(read(bundle).keySet()).containsAll(asked);
                    assertThat(literals).containsAll(read(bundle).keySet());
                }));
    }

    @Test
    void noClassHoldsATextItself() throws IOException {
        List<Path> windows = sources(MAIN, Integer.MAX_VALUE).stream()
                .filter(file -> WINDOWS.matcher(MAIN.relativize(file).toString().replace('\\', '/'))
                        .matches())
                .toList();
        List<String> left = new ArrayList<>();
        parse(windows).forEach(source -> new TextScanner(source, left).scan(source.unit(), null));
        assertThat(left).isEmpty();
    }

    private static List<Path> sources(Path folder, int depth) throws IOException {
        try (Stream<Path> files = Files.walk(folder, depth)) {
            return files.filter(file -> file.toString().endsWith(".java")).toList();
        }
    }

    private static List<Path> bundles() throws IOException {
        try (Stream<Path> files = Files.walk(MAIN.resolve("resources"))) {
            List<Path> bundles =
                    files.filter(file -> file.endsWith("Texts.properties")).toList();
            return bundles;
        }
    }

    private static Map<String, String> read(Path bundle) throws IOException {
        Properties texts = new Properties();
        try (Reader in = Files.newBufferedReader(bundle, StandardCharsets.UTF_8)) {
            texts.load(in);
        }
        return texts.stringPropertyNames().stream().collect(Collectors.toMap(key -> key, texts::getProperty));
    }

    private static List<Source> parse(List<Path> files) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        try (StandardJavaFileManager manager = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
            JavacTask task = (JavacTask)
                    compiler.getTask(null, manager, null, null, null, manager.getJavaFileObjectsFromPaths(files));
            SourcePositions positions = Trees.instance(task).getSourcePositions();
            List<Source> sources = new ArrayList<>();
            task.parse().forEach(unit -> sources.add(new Source(unit, positions)));
            return sources;
        }
    }

    private record Source(CompilationUnitTree unit, SourcePositions positions) {
        private String place(LiteralTree literal) {
            long line = unit.getLineMap().getLineNumber(positions.getStartPosition(unit, literal));
            return unit.getSourceFile().getName() + ":" + line + ": " + literal.getValue();
        }
    }

    private static String nameOf(ExpressionTree call) {
        return call instanceof MemberSelectTree member
                ? member.getIdentifier().toString()
                : call instanceof IdentifierTree name ? name.getName().toString() : "";
    }

    /** Collects the keys in calls such as {@code TEXTS.get("save")}. */
    private static final class KeyScanner extends TreeScanner<Void, Void> {
        private final Set<String> keys;

        private KeyScanner(Set<String> keys) {
            this.keys = keys;
        }

        @Override
        public Void visitMethodInvocation(MethodInvocationTree call, Void nothing) {
            if (call.getMethodSelect() instanceof MemberSelectTree member
                    && member.getExpression().toString().equals("TEXTS")
                    && call.getArguments().get(0) instanceof LiteralTree key) {
                keys.add("" + key.getValue());
            }
            return super.visitMethodInvocation(call, nothing);
        }
    }

    private static final class LiteralScanner extends TreeScanner<Void, Void> {
        private final Set<String> values;

        private LiteralScanner(Set<String> values) {
            this.values = values;
        }

        @Override
        public Void visitLiteral(LiteralTree literal, Void nothing) {
            if (literal.getValue() instanceof String value) {
                values.add(value);
            }
            return null;
        }
    }

    /** Collects literals that read like texts, but for those that no user sees. */
    private static final class TextScanner extends TreeScanner<Void, Void> {
        private final Source source;
        private final List<String> found;

        private TextScanner(Source source, List<String> found) {
            this.source = source;
            this.found = found;
        }

        @Override
        public Void visitMethodInvocation(MethodInvocationTree call, Void nothing) {
            if (!UNSEEN.contains(nameOf(call.getMethodSelect()))) {
                return super.visitMethodInvocation(call, nothing);
            }
            scan(call.getMethodSelect(), nothing);
            call.getArguments().stream()
                    .filter(LambdaExpressionTree.class::isInstance)
                    .forEach(argument -> scan(argument, nothing));
            return null;
        }

        @Override
        public Void visitNewClass(NewClassTree creation, Void nothing) {
            return UNSEEN_CLASSES.contains(nameOf(creation.getIdentifier()))
                    ? null
                    : super.visitNewClass(creation, nothing);
        }

        @Override
        public Void visitAnnotation(AnnotationTree annotation, Void nothing) {
            return null;
        }

        @Override
        public Void visitLiteral(LiteralTree literal, Void nothing) {
            if (literal.getValue() instanceof String text
                    && WORDS.matcher(TAG.matcher(text).replaceAll("")).matches()
                    && !LAYOUT.matcher(text).matches()
                    && !KEYS.matcher(text).matches()) {
                found.add(source.place(literal));
            }
            return null;
        }
    }
}
