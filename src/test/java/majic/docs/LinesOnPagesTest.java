package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import majic.Majic;
import majic.program.UserFolder;
import majic.script.commands.ScriptParser;
import majic.script.syntax.Mistake;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;

/** Tests the lines to type on the pages of the documentation: MAJIC Script, and the command line of the shell. */
class LinesOnPagesTest {
    private static final Set<String> LANGUAGES = Set.of(
            "majic", "java", "sh", "console", "python", "matlab", "ebnf", "yaml", "text", "urbi", "mermaid", "xml");
    private static final List<String> TYPES = List.of("aibo", "pioneer", "hemisson");
    private static final Pattern SCRIPT = Pattern.compile("(\\d[\\d,-]*|all|me) [a-z].*");
    private static final Pattern CALL = Pattern.compile("(?:^|[ |])\\./majic(?<words> [^|#>]*)?");
    private static final Pattern WORD = Pattern.compile("\"[^\"]*\"|[^\" ]+");
    private static final Pattern FILE = Pattern.compile("(?<![\\w/.])([\\w/]+\\.(?:java|py|majic|u|cpp|act))\\b");
    private static final Pattern OPTION = Pattern.compile("--\\w[\\w-]*");

    static Stream<Page.Code> blocks() {
        return Page.all().stream().flatMap(page -> page.blocks().stream());
    }

    static Stream<Page.Code> scripts() {
        return blocks().filter(block -> block.language().equals("majic"));
    }

    static Stream<Page.Code> spans() {
        return Page.all().stream().flatMap(Page::spans);
    }

    static Stream<Page.Code> lines() {
        return spans().filter(LinesOnPagesTest::isForRobots);
    }

    /** Returns whether a piece of code is a line of MAJIC Script that begins with robots. */
    static boolean isForRobots(Page.Code span) {
        return SCRIPT.matcher(span.text()).matches();
    }

    static Stream<Page.Code> calls() {
        return Stream.concat(spans(), blocks().filter(block -> isShell(block.language())))
                .filter(code -> CALL.matcher(code.text()).find());
    }

    static Stream<Page.Code> commands() {
        return Stream.concat(blocks().filter(block -> isShell(block.language())), calls())
                .distinct();
    }

    static Stream<Page.Code> options() {
        return spans().filter(span -> OPTION.matcher(span.text()).lookingAt());
    }

    private static boolean isShell(String language) {
        return language.equals("sh") || language.equals("console");
    }

    @ParameterizedTest
    @MethodSource("blocks")
    void everyBlockNamesItsLanguage(Page.Code block) {
        assertThat(LANGUAGES).contains(block.language());
    }

    @ParameterizedTest
    @MethodSource({"scripts", "lines"})
    void everyScriptIsCorrect(Page.Code script) {
        List<Mistake> mistakes = new ArrayList<>();
        ScriptParser.parse(script.text(), TYPES, mistakes);
        assertThat(mistakes).isEmpty();
    }

    @ParameterizedTest
    @MethodSource("calls")
    void everyCallOfMajicIsCorrect(Page.Code code) {
        for (String line : code.lines()) {
            Matcher call = CALL.matcher(line);
            if (call.find()) {
                String[] words = words(call.group("words"));
                assertThatCode(() -> commandLine().parseArgs(words)).as(line).doesNotThrowAnyException();
            }
        }
    }

    /** A file of an act has the source of the same name. */
    @ParameterizedTest
    @MethodSource("commands")
    void everyFileOfACommandExistsOrIsOnAPage(Page.Code commands) {
        String typed = commands.language().equals("console")
                ? String.join(
                        "\n",
                        commands.lines().stream()
                                .filter(line -> line.startsWith("$ "))
                                .toList())
                : commands.text();
        assertThat(FILE.matcher(typed).results())
                .allSatisfy(file -> assertThat(Files.exists(Path.of(file.group(1)))
                                || isOnAPage(file.group(1).replaceFirst("act$", "java")))
                        .as(file.group(1))
                        .isTrue());
    }

    private static boolean isOnAPage(String file) {
        return Page.all().stream().anyMatch(page -> page.text().contains("Write this into `" + file + "`:\n\n```"));
    }

    @ParameterizedTest
    @MethodSource("options")
    void everyOptionExists(Page.Code span) {
        Matcher option = OPTION.matcher(span.text());
        assertThat(option.lookingAt()).isTrue();
        assertThat(optionsOf(commandLine())).contains(option.group());
    }

    private static String[] words(@Nullable String text) {
        return WORD.matcher(text == null ? "" : text)
                .results()
                .map(MatchResult::group)
                .toArray(String[]::new);
    }

    private static CommandLine commandLine() {
        return Majic.commandLine(new UserFolder(Path.of("none")));
    }

    private static Collection<String> optionsOf(CommandLine command) {
        Set<String> names = new TreeSet<>(command.getCommandSpec().optionsMap().keySet());
        command.getSubcommands().values().forEach(one -> names.addAll(optionsOf(one)));
        return names;
    }
}
