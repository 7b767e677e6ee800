package majic.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import com.sun.source.tree.BinaryTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ConditionalExpressionTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.ParenthesizedTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreeScanner;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import majic.link.Links;
import majic.pioneer.PioneerType;
import org.junit.jupiter.api.Test;

class ErrorWordsTest {
    private static final int LEAST_LITERAL = 6;

    @Test
    void aRefusedConnectionIsExplainedInGermanWithItsAdvice() throws IOException {
        int port;
        try (ServerSocket closed = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = closed.getLocalPort();
        }
        String english = String.valueOf(
                catchThrowable(() -> Links.of("//127.0.0.1:" + port, 1, 1).open(2000))
                        .getMessage());
        String german = ErrorWords.german(Advice.after(english, new PioneerType().advice()));
        assertThat(german)
                .isEqualTo("auf 127.0.0.1 port " + port + " wartet kein Programm auf Verbindungen. Ist der Roboter"
                        + " eingeschaltet, sein serielles Kabel oder seine Netzwerkbrücke eingesteckt und kein anderes"
                        + " Programm mit ihm verbunden? Ein Pioneer spricht mit einem Programm zur selben Zeit; sein"
                        + " Port im Netzwerk ist meist 8101.");
    }

    @Test
    void aReasonInAGapIsTranslatedToo() {
        String english = "/no/such/lap.majic: cannot be written (" + IoReason.of(new NoSuchFileException("x")) + ")";
        assertThat(ErrorWords.german(english))
                .isEqualTo("/no/such/lap.majic: lässt sich nicht schreiben (es gibt keinen solchen Ordner und keine"
                        + " solche Datei)");
    }

    @Test
    void anUnknownSentenceStaysAsItIs() {
        assertThat(ErrorWords.german("the moon is full; wait. Then try again."))
                .isEqualTo("the moon is full; wait. Then try again.");
    }

    @Test
    void anEnglishWindowShowsTheSentencesAsTheyAre() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.ENGLISH);
            assertThat(ErrorWords.of("it is not allowed")).isEqualTo("it is not allowed");
            Locale.setDefault(Locale.GERMAN);
            assertThat(ErrorWords.of("it is not allowed")).isEqualTo("es ist nicht erlaubt");
        } finally {
            Locale.setDefault(before);
        }
    }

    /** A sentence that was changed in the program would no longer be translated. */
    @Test
    void everyEnglishSentenceOfTheListIsInTheProgram() throws IOException {
        String program = sources();
        List<String> gone = list().stream()
                .flatMap(line -> Arrays.stream(line.split(" => ")[0].split("\\{\\d}")))
                .map(String::strip)
                .filter(part -> part.length() >= LEAST_LITERAL)
                .filter(part -> !program.contains(part.replace("\"", "\\\"")))
                .filter(part -> !isOfTheSystem(part) && !part.equals(COMPOSED))
                .toList();
        assertThat(gone).isEmpty();
    }

    /**
     * Exceptions of these files and packages reach dialogs and notices: a new one needs a German sentence. Messages
     * that are not written in place of the exception are not found by this test.
     */
    private static final List<String> SHOWN = List.of(
            "link/",
            "file/",
            "recorder/RecordingHead",
            "recorder/RecordingReader",
            "act/file/",
            "act/make/",
            "team/",
            "vendor/",
            "simulation/");

    /** Errors of a program that embeds MAJIC or of its own code, and names for exceptions of files. */
    private static final Set<String> NOT_SHOWN = Set.of(
            "IllegalArgumentException",
            "IllegalStateException",
            "ClassNotFoundException",
            "NoSuchFileException",
            "UncheckedIOException",
            "AssertionError");

    /** What the owner of a robot does has sentences of its own. */
    private static final String OWNED = "X is X; \"X stop\" ends it";

    @Test
    void everyErrorThatDialogsShowHasAGermanSentence() throws IOException {
        Pattern english = Pattern.compile("\\b(the|is|it|has|not|there|which|and|of|cannot|no)\\b");
        List<String> untranslated = new ArrayList<>();
        for (String message : messages()) {
            String german = ErrorWords.german(message);
            if (!message.equals(OWNED) && english.matcher(german).find()) {
                untranslated.add(message + " => " + german);
            }
        }
        assertThat(untranslated).isEmpty();
    }

    /** Returns the messages of all exceptions that are made in the shown packages, with words in their gaps. */
    private static List<String> messages() throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.walk(Path.of("src/main/java/majic"))) {
            files = all.filter(file -> SHOWN.stream()
                            .anyMatch(part -> file.toString().replace('\\', '/').contains("/majic/" + part)))
                    .filter(file -> file.toString().endsWith(".java"))
                    .toList();
        }
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        List<String> messages = new ArrayList<>();
        try (StandardJavaFileManager manager = compiler.getStandardFileManager(null, null, null)) {
            JavacTask task = (JavacTask) compiler.getTask(
                    null,
                    manager,
                    error -> {},
                    List.of("-proc:none"),
                    null,
                    manager.getJavaFileObjectsFromPaths(files));
            for (CompilationUnitTree unit : task.parse()) {
                new TreeScanner<Void, Void>() {
                    @Override
                    public Void visitNewClass(NewClassTree made, Void nothing) {
                        String type = made.getIdentifier().toString();
                        if (type.endsWith("Exception") && !NOT_SHOWN.contains(type)) {
                            made.getArguments().stream()
                                    .map(ErrorWordsTest::texts)
                                    .filter(texts -> !texts.equals(List.of("X")))
                                    .findFirst()
                                    .ifPresent(texts -> texts.forEach(text ->
                                            messages.add(type.equals("InvalidActException") ? "X " + text : text)));
                        }
                        return super.visitNewClass(made, nothing);
                    }
                }.scan(unit, null);
            }
        }
        assertThat(messages).hasSizeGreaterThan(100);
        return messages;
    }

    /** Returns the values that an expression can have, with X for its parts that are no texts. */
    private static List<String> texts(ExpressionTree of) {
        if (of instanceof LiteralTree literal && literal.getValue() instanceof String text) {
            return List.of(text);
        }
        if (of instanceof ParenthesizedTree brackets) {
            return texts(brackets.getExpression());
        }
        if (of instanceof ConditionalExpressionTree choice) {
            return Stream.concat(
                            texts(choice.getTrueExpression()).stream(), texts(choice.getFalseExpression()).stream())
                    .distinct()
                    .toList();
        }
        if (of instanceof BinaryTree sum && sum.getKind() == Tree.Kind.PLUS) {
            List<String> ends = texts(sum.getRightOperand());
            return texts(sum.getLeftOperand()).stream()
                    .flatMap(begin -> ends.stream().map(end -> begin + end))
                    .toList();
        }
        return List.of("X");
    }

    @Test
    void theOwnerOfARobotIsNamedInGerman() {
        assertThat(ErrorWords.german("2 is running Pair; \"2 stop\" ends it"))
                .isEqualTo("2 führt Pair aus; „2 stop“ beendet das");
    }

    @Test
    void aReasonInBracketsBehindAGermanSentenceIsTranslated() {
        assertThat(ErrorWords.german("a.csv ließ sich nicht lesen (it is not allowed)"))
                .isEqualTo("a.csv ließ sich nicht lesen (es ist nicht erlaubt)");
    }

    /** The verb and the occupation are apart in the program. */
    private static final String COMPOSED = "is driven by hand";

    private static boolean isOfTheSystem(String part) {
        return List.of("is a directory", "no space left on device", "read-only file system")
                .contains(part);
    }

    private static List<String> list() throws IOException {
        return Files.readAllLines(Path.of("src/main/resources/majic/text/errors_de.txt"), StandardCharsets.UTF_8)
                .stream()
                .filter(line -> line.contains(" => "))
                .toList();
    }

    /** Returns all sources, with the pieces of each text joined. */
    private static String sources() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/main/java"))) {
            return files.filter(file -> file.toString().endsWith(".java"))
                    .map(ErrorWordsTest::read)
                    .collect(Collectors.joining("\n"))
                    .replaceAll("\"\\s*\\+\\s*\"", "");
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
