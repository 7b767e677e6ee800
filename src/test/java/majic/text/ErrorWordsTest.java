package majic.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import com.sun.source.tree.BinaryTree;
import com.sun.source.tree.CaseTree;
import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ConditionalExpressionTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.LambdaExpressionTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.ParenthesizedTree;
import com.sun.source.tree.ReturnTree;
import com.sun.source.tree.SwitchExpressionTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
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
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.lang.model.element.Modifier;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import majic.link.Links;
import majic.pioneer.PioneerType;
import org.jspecify.annotations.Nullable;
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
    void aStopThatALostRobotHasNotConfirmedIsExplainedToTheEnd() {
        assertThat(ErrorWords.german("the connection to robot 1 of desk2 was lost before its stop was confirmed; if it"
                        + " is at rest, \"remove 5\" ends this alarm; \"add ADDRESS as 5\" connects it under another"
                        + " address"))
                .isEqualTo(
                        "die Verbindung zu Roboter 1 von desk2 ging verloren, bevor sein Stopp bestätigt war; wenn er"
                                + " steht, beendet „remove 5“ diesen Alarm; „add ADRESSE as 5“ verbindet ihn unter einer anderen"
                                + " Adresse");
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
                .filter(part -> !isOfTheSystem(part) && !COMPOSED.contains(part))
                .toList();
        assertThat(gone).isEmpty();
    }

    /**
     * Exceptions of these files and packages reach dialogs, panels and notices: a new one needs a German sentence. Of
     * messages that are not written in place of the exception, those are found that a constant or a method of these
     * files gives.
     */
    private static final List<String> SHOWN = List.of(
            "link/",
            "file/",
            "recorder/",
            "act/",
            "team/",
            "vendor/",
            "simulation/",
            "text/ClassReason",
            "program/ProgramSharing",
            "bot/BotAddress",
            "bot/MajicBot",
            "driver/BotDriver",
            "driver/ConnectionLife",
            "driver/DriverCode",
            "driver/LinkReader",
            "driver/Motion",
            "driver/MovingRobot",
            "driver/PermittedControl",
            "driver/RobotWait",
            "driver/ShutdownHook",
            "aibo/",
            "pioneer/",
            "hemisson/",
            "mavlink/",
            "ros/",
            "shared/",
            "velocity/");

    /** What only MAJIC Script, the command line or another program can cause, whose answers are English. */
    private static final List<String> ANSWERS = List.of(
            "act/MajicAct",
            "aibo/sound/",
            "hemisson/modules/",
            "mavlink/parameters/",
            "ros/parameters/",
            "ros/navigation/",
            "pioneer/parameters/",
            "shared/embedded/",
            "shared/vda5050/",
            "shared/desk/UntilText");

    /** The exceptions whose names do not end in "Exception". */
    private static final Set<String> OTHER_EXCEPTIONS = Set.of(
            "ConnectFailed",
            "LinkLost",
            "MotionFailed",
            "MotionStopped",
            "NotWebSocket",
            "ServiceFailed",
            "UrbiRefusal");

    /**
     * Errors of a program that embeds MAJIC or of its own code, names for exceptions of files, and answers to values
     * that were typed and to messages of other programs.
     */
    private static final Set<String> NOT_SHOWN = Set.of(
            "IllegalArgumentException",
            "IllegalStateException",
            "ClassNotFoundException",
            "NoSuchFileException",
            "NoSuchMethodException",
            "ParameterException",
            "TimeoutException",
            "UncheckedIOException",
            "UnusableMessageException",
            "AssertionError");

    /** What the owner of a robot does, and how a moving Hemisson was lost, have sentences of their own. */
    private static final Set<String> IN_PIECES =
            Set.of("X is X; \"X stop\" ends it", "X; Xif it still moves, lift it, or press 5 on a TV remote control");

    @Test
    void everyErrorThatDialogsShowHasAGermanSentence() throws IOException {
        Pattern english = Pattern.compile("\\b(the|is|it|has|not|there|which|and|of|cannot|no)\\b");
        List<String> untranslated = new ArrayList<>();
        for (String message : messages()) {
            String german = ErrorWords.german(message);
            if (!IN_PIECES.contains(message) && english.matcher(german).find()) {
                untranslated.add(message + " => " + german);
            }
        }
        assertThat(untranslated).isEmpty();
    }

    /** Returns the messages of all exceptions that are made in the shown packages, with words in their gaps. */
    private static List<String> messages() throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.walk(Path.of("src/main/java/majic"))) {
            files = all.filter(file -> isOneOf(SHOWN, file) && !isOneOf(ANSWERS, file))
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
            List<CompilationUnitTree> units = new ArrayList<>();
            task.parse().forEach(units::add);
            TextFinder finder = new TextFinder();
            units.forEach(unit -> finder.scan(unit, null));
            units.forEach(unit -> new MessageFinder(finder, messages).scan(unit, null));
        }
        assertThat(messages).hasSizeGreaterThan(400);
        return messages;
    }

    private static boolean isOneOf(List<String> parts, Path file) {
        String name = file.toString().replace('\\', '/');
        return parts.stream().anyMatch(part -> name.contains("/majic/" + part));
    }

    /** Follows the class that is scanned. */
    private static class InClass extends TreeScanner<Void, Void> {
        String name = "";

        @Override
        public Void visitClass(ClassTree inner, Void nothing) {
            String outer = name;
            name = inner.getSimpleName().toString();
            super.visitClass(inner, nothing);
            name = outer;
            return null;
        }
    }

    /** Collects the messages of exceptions. */
    private static final class MessageFinder extends InClass {
        private final TextFinder finder;
        private final List<String> messages;

        MessageFinder(TextFinder finder, List<String> messages) {
            this.finder = finder;
            this.messages = messages;
        }

        @Override
        public Void visitNewClass(NewClassTree made, Void nothing) {
            String type = made.getIdentifier().toString();
            if (OTHER_EXCEPTIONS.contains(type) || type.endsWith("Exception") && !NOT_SHOWN.contains(type)) {
                made.getArguments().stream()
                        .map(argument -> finder.texts(argument, name, 0))
                        .filter(texts -> !texts.equals(UNKNOWN))
                        .findFirst()
                        .ifPresent(texts -> texts.forEach(
                                text -> messages.add(type.equals("InvalidActException") ? "X " + text : text)));
            }
            return super.visitNewClass(made, nothing);
        }
    }

    private static final List<String> UNKNOWN = List.of("X");

    /** Collects what constants hold and what methods return, by class and name, to find the texts of expressions. */
    private static final class TextFinder extends InClass {
        private static final int MOST_STEPS = 4;

        private final Map<String, List<ExpressionTree>> values = new HashMap<>();
        private String method = "";

        @Override
        public Void visitVariable(VariableTree variable, Void nothing) {
            if (variable.getInitializer() != null
                    && variable.getModifiers().getFlags().contains(Modifier.STATIC)
                    && isText(variable.getType())) {
                add("" + variable.getName(), variable.getInitializer());
            }
            return super.visitVariable(variable, nothing);
        }

        @Override
        public Void visitMethod(MethodTree declared, Void nothing) {
            return within(
                    isText(declared.getReturnType()) ? "" + declared.getName() : "",
                    () -> super.visitMethod(declared, nothing));
        }

        @Override
        public Void visitLambdaExpression(LambdaExpressionTree lambda, Void nothing) {
            return within("", () -> super.visitLambdaExpression(lambda, nothing));
        }

        private Void within(String inner, Supplier<Void> scan) {
            String outer = method;
            method = inner;
            scan.get();
            method = outer;
            return null;
        }

        @Override
        public Void visitReturn(ReturnTree end, Void nothing) {
            if (!method.isEmpty()) {
                add(method, end.getExpression());
            }
            return super.visitReturn(end, nothing);
        }

        private void add(String member, ExpressionTree value) {
            values.computeIfAbsent(name + "." + member, key -> new ArrayList<>())
                    .add(value);
        }

        private static boolean isText(@Nullable Tree type) {
            return String.valueOf(type).endsWith("String");
        }

        /** Returns the values that an expression can have, with X for its parts that are no texts. */
        List<String> texts(ExpressionTree of, String in, int steps) {
            if (of instanceof LiteralTree literal && literal.getValue() instanceof String text) {
                return List.of(text);
            }
            if (of instanceof ParenthesizedTree brackets) {
                return texts(brackets.getExpression(), in, steps);
            }
            if (of instanceof ConditionalExpressionTree choice) {
                return Stream.of(choice.getTrueExpression(), choice.getFalseExpression())
                        .flatMap(each -> texts(each, in, steps).stream())
                        .distinct()
                        .toList();
            }
            if (of instanceof SwitchExpressionTree choice) {
                return choice.getCases().stream()
                        .map(CaseTree::getBody)
                        .filter(ExpressionTree.class::isInstance)
                        .flatMap(each -> texts((ExpressionTree) each, in, steps).stream())
                        .distinct()
                        .toList();
            }
            if (of instanceof BinaryTree sum && sum.getKind() == Tree.Kind.PLUS) {
                List<String> ends = texts(sum.getRightOperand(), in, steps);
                return texts(sum.getLeftOperand(), in, steps).stream()
                        .flatMap(begin -> ends.stream().map(end -> begin + end))
                        .toList();
            }
            if (of instanceof MethodInvocationTree call
                    && call.getMethodSelect().toString().equals("String.format")) {
                return texts(call.getArguments().get(1), in, steps).stream()
                        .map(text -> text.replaceAll("%[\\d.]*[sdf]", "X"))
                        .toList();
            }
            return steps == MOST_STEPS ? UNKNOWN : named(of, in, steps);
        }

        /** Returns the values of a constant or a method. */
        private List<String> named(ExpressionTree of, String in, int steps) {
            ExpressionTree member = of instanceof MethodInvocationTree call ? call.getMethodSelect() : of;
            String key = member instanceof MemberSelectTree select
                    ? select.getExpression().toString().replaceFirst(".*\\.", "") + "." + select.getIdentifier()
                    : in + "." + member;
            String owner = key.substring(0, key.indexOf('.'));
            return values.containsKey(key)
                    ? values.get(key).stream()
                            .flatMap(value -> texts(value, owner, steps + 1).stream())
                            .distinct()
                            .toList()
                    : UNKNOWN;
        }
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

    /** Parts of sentences that are apart in the program. */
    private static final Set<String> COMPOSED = Set.of("is driven by hand", "(no robots yet; add one)");

    /** Sentences of the system and of libraries. */
    private static boolean isOfTheSystem(String part) {
        return List.of(
                        "is a directory",
                        "no space left on device",
                        "read-only file system",
                        "Couldn't load shared library '",
                        "' for target:",
                        "Failed to initialize SDL in native method!",
                        "SDL is already initialized!")
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
