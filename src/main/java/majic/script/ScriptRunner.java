package majic.script;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import majic.bot.BotException;
import majic.log.Line;
import majic.script.commands.ScriptFiles;
import majic.script.conditions.Selection;
import majic.script.help.Completion;
import majic.script.help.Completions;
import majic.script.help.ScriptNames;
import majic.script.help.VariableCompletion;
import majic.script.help.VisibleNames;
import majic.script.help.WordPlace;
import majic.script.run.Execution;
import majic.script.run.ExecutionEnded;
import majic.script.run.InternalError;
import majic.script.run.RobotsIn;
import majic.script.run.Scope;
import majic.script.run.ScriptControl;
import majic.script.run.ScriptSource;
import majic.script.run.Statement;
import majic.script.run.SubmittedCommands;
import majic.script.run.Types;
import majic.script.syntax.Mistake;
import majic.team.Answer;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Checks scripts that are being edited, and runs them as {@code run FILE} does, but under control: such a run can be
 * paused, stepped and ended. Thread-safe.
 */
public final class ScriptRunner {
    private final Session session;
    private final ScriptFiles scripts;
    private final Selection selection;
    private volatile @Nullable ScriptNames lastNames;

    /**
     * Creates a runner for the robots of a session.
     *
     * @param session receives the answers, and records what the scripts do
     */
    public ScriptRunner(Session session) {
        this.session = session;
        this.scripts = new ScriptFiles(session.state());
        this.selection = new Selection(session.team());
    }

    /**
     * What is known of a script before it runs. Immutable.
     *
     * @param mistakes what is wrong in it, in the order of its lines; empty if it can run
     * @param robots the robots of the team that it commands, in the order of the script
     */
    public record Checked(List<Mistake> mistakes, List<Member> robots) {
        /** Keeps copies of the lists; sorts the mistakes by their places. */
        public Checked {
            mistakes = mistakes.stream()
                    .sorted(Comparator.comparingInt(Mistake::line).thenComparingInt(Mistake::column))
                    .toList();
            robots = List.copyOf(robots);
        }
    }

    /**
     * Checks a script against the robots that are there; runs nothing. Reads the files that it names, so it may block.
     *
     * @param text the script
     * @return what is wrong in it, and which robots it commands
     */
    public Checked check(String text) {
        List<Mistake> mistakes = new ArrayList<>();
        List<Statement> script = scripts.checked(text, selection, mistakes);
        return new Checked(mistakes, List.copyOf(RobotsIn.of(script, selection).commanded()));
    }

    /**
     * Returns what could be typed at a place of a script: commands, robots, parameters of the robots on the line, words
     * that a parameter takes. Reads files if {@link MajicParser#readsFiles} says so.
     *
     * @param line one line of the script
     * @param caret where the word ends that is to be completed, 0 to the length of the line
     * @return words that replace the one before the caret, and hints
     */
    public Completions complete(String line, int caret) {
        return complete(line, caret, VisibleNames.NONE);
    }

    /**
     * Returns what could be typed at a place of a script, as {@link #complete(String, int)} does.
     *
     * @param names those that the line may use
     */
    public Completions complete(String line, int caret, VisibleNames names) {
        return session.completer().complete(line, caret, List.of(), names);
    }

    /**
     * Returns the names that a line of a script may use. The script is parsed when the names are first needed.
     *
     * @param text the script
     * @param line the number of the line, from 1
     */
    public VisibleNames names(String text, int line) {
        ScriptNames last = lastNames;
        if (last == null || !last.isFor(text, line)) {
            last = new ScriptNames(text, line, () -> new Types(selection));
            lastNames = last;
        }
        return last;
    }

    /**
     * Returns the names, such as {@code $speed}, that could be typed at a place of a script. Reads no files.
     *
     * @param names those that the line may use
     * @param line one line of the script
     * @param caret where the name ends that is to be completed, 0 to the length of the line
     * @return empty if no name that begins with {@code $} ends there
     */
    public Optional<Completions> completeVariable(VisibleNames names, String line, int caret) {
        return VariableCompletion.complete(names, line.substring(0, caret));
    }

    /**
     * Explains a word of a script: a command, a robot, a parameter, or the value that is expected in its place. Reads
     * no files, so nothing is known of names of acts and files.
     *
     * @param line one line of the script
     * @param index a place that the word touches, 0 to the length of the line; in a gap, what is expected there is
     *     explained
     * @param names those that the line may use
     * @return empty if nothing is known of the word
     */
    public Optional<Completion> explain(String line, int index, VisibleNames names) {
        WordPlace word = WordPlace.at(line, index);
        Optional<Completions> variable = completeVariable(names, line, word.end());
        if (variable.isPresent()) {
            Completions found = variable.get();
            return found.meaning(line.substring(found.start(), word.end()));
        }
        return MajicParser.readsFiles(line.substring(0, word.start()))
                ? Optional.empty()
                : complete(line, word.end(), names).meaning(line.substring(word.start(), word.end()));
    }

    /**
     * Runs a script on a thread of its own; returns at once. It is checked first, and owns the robots that it commands
     * until it ends. Its mistakes, answers and end go to the listeners of the session.
     *
     * @param source the script
     * @param paused whether it waits before its first line
     * @return its control, which returns the outcome at the end
     */
    public ScriptControl run(ScriptSource source, boolean paused) {
        session.output().send(Line.Kind.COMMAND, source.title(), this);
        ScriptControl control = new ScriptControl(session.team().changes(), paused);
        Execution.Origin origin = new Execution.Origin(session.state(), new SubmittedCommands(), this, new Scope<>());
        Execution line = new Execution(origin, selection, Execution.Manner.TYPED, Map.of(), () -> false);
        boolean begun = session.team()
                .time()
                .tryRunAsync("script: " + source.title(), () -> control.ended(run(source, line, control)));
        if (!begun) {
            control.ended(failed(source, "the system has no thread left for it; end an act or a program"));
        }
        return control;
    }

    /** Blocks until the script has ended; returns how, unless the script has reported that already. */
    private String run(ScriptSource source, Execution line, ScriptControl control) {
        try {
            scripts.run(source, line, control);
            return "done";
        } catch (ExecutionEnded e) {
            boolean stopped = e.outcome() == Answer.Outcome.STOPPED;
            return report(stopped ? Line.Kind.ANSWER : Line.Kind.FAILURE, source, e.ending());
        } catch (BotException e) {
            return failed(source, String.valueOf(e.getMessage()));
        } catch (RuntimeException | Error e) {
            return failed(source, InternalError.report(source.title(), e));
        }
    }

    private String failed(ScriptSource source, String why) {
        return report(Line.Kind.FAILURE, source, "failed: " + why);
    }

    private String report(Line.Kind kind, ScriptSource source, String how) {
        session.output().send(kind, source.title() + ": " + how, this);
        return how;
    }
}
