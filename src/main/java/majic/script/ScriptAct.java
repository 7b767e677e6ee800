package majic.script;

import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import majic.act.ActArgument;
import majic.act.ActException;
import majic.act.MajicAct;
import majic.act.Role;
import majic.act.file.ActCatalog;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.bot.Value;
import majic.log.Line;
import majic.script.acts.ScriptActProgram;
import majic.script.run.Execution;
import majic.script.run.ExecutionEnded;
import majic.script.run.ScriptExecution;
import majic.script.run.ScriptSource;
import majic.script.run.SessionState;
import majic.script.syntax.Mistake;
import majic.script.syntax.ScriptException;
import majic.team.Answer;
import majic.team.Member;
import majic.team.Owner;
import org.jspecify.annotations.Nullable;

/**
 * A behaviour written in MAJIC Script. It is data only: saved and read back it brings no code. Each robot number in it
 * is a role, {@code me} the robot it runs on; without a {@code me} that is the robot named first.
 */
public final class ScriptAct extends MajicAct {
    /** How files with scripts end. */
    public static final String ENDING = ActCatalog.SCRIPT_ENDING;

    private static final long serialVersionUID = 1;

    private final String title;
    private final String text;
    private transient volatile @Nullable Stage stage;

    /** The values that arguments were given, by name in lower case; null if none was. */
    private transient volatile @Nullable Map<String, Value> given;

    /** Where it runs. */
    private record Stage(Execution line, Owner act, Map<String, Member> robots) {}

    /**
     * A behaviour from a script or a saved session.
     *
     * @param title the name in messages about its mistakes
     * @param text the script, its lines apart by line breaks
     * @throws BotException if it has mistakes, or commands that only a session may have; one line for each, with its
     *     place
     */
    public ScriptAct(String title, String text) {
        this.title = title;
        this.text = text;
        program();
    }

    /**
     * A behaviour from a file.
     *
     * @param file a script or a saved session
     * @return the act, named after the file
     * @throws BotException if it cannot be read, or is no behaviour
     */
    public static ScriptAct read(Path file) {
        return new ScriptAct(String.valueOf(file.getFileName()), ScriptSource.textOf(file));
    }

    /**
     * The name in messages about its mistakes.
     *
     * @return the name of the file it was made of
     */
    public String title() {
        return title;
    }

    /**
     * The script.
     *
     * @return its lines
     */
    public String text() {
        return text;
    }

    /**
     * Returns the comment at the head of the script, which describes it.
     *
     * @return its lines in one; empty if the script begins otherwise
     */
    public String description() {
        return text.lines()
                .map(String::strip)
                .takeWhile(line -> line.startsWith("#"))
                .map(line -> line.substring(1).strip())
                .filter(line -> !line.isEmpty())
                .collect(Collectors.joining(" "));
    }

    private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
        in.defaultReadObject();
        if (title == null || text == null) {
            throw new InvalidObjectException("its script is missing");
        }
        try {
            program();
        } catch (BotException e) {
            String first = String.valueOf(e.getMessage()).lines().findFirst().orElse("");
            throw (IOException) new InvalidObjectException(first).initCause(e);
        }
    }

    @Override
    public List<Role> roles() {
        return program().roles();
    }

    @Override
    public List<ActArgument> arguments() {
        return ScriptActProgram.of(title, text, Map.of()).arguments();
    }

    @Override
    public void setArgument(String name, Value value) {
        List<ActArgument> arguments = arguments();
        ActArgument argument = arguments.stream()
                .filter(one -> one.isNamed(name))
                .findFirst()
                .orElseThrow(() -> new ActException(ActArgument.unknown(name, arguments)));
        Map<String, Value> values = new HashMap<>(values());
        values.put(name.toLowerCase(Locale.ROOT), argument.parameter().fit(value));
        given = values;
    }

    private Map<String, Value> values() {
        Map<String, Value> values = given;
        return values == null ? Map.of() : values;
    }

    private ScriptActProgram program() {
        return ScriptActProgram.of(title, text, values());
    }

    /** Sets where it runs, before it is started; a robot for each role. */
    void enter(Execution line, Owner act, Map<String, List<Member>> robots) {
        stage = new Stage(line, act, first(robots));
    }

    private static Map<String, Member> first(Map<String, List<Member>> cast) {
        Map<String, Member> one = new LinkedHashMap<>();
        cast.forEach((role, robots) -> one.put(role, robots.get(0)));
        return one;
    }

    /**
     * Checks whether robots can do what it commands; sends nothing.
     *
     * @throws BotException if not, one line for each mistake, with its place
     */
    void check(SessionState session, Map<String, List<Member>> cast) {
        ScriptActProgram behaviour = program();
        ScriptActProgram.refuse(title, behaviour.check(session, first(cast)));
    }

    @Override
    protected void behave() {
        Stage here = stage;
        if (here == null) {
            throw new BotException("an act in MAJIC Script runs in a session: 1 act FILE");
        }
        ScriptActProgram behaviour = program();
        refuse(behaviour.check(here.line.session(), here.robots), here);
        try {
            ScriptExecution.ofAct(here.line, here.act, behaviour.among(here.robots))
                    .runAct(behaviour.statements());
        } catch (ExecutionEnded e) {
            throw e.outcome() == Answer.Outcome.STOPPED
                    ? new MotionStopped("stopped")
                    : new BotException(String.valueOf(e.getMessage()), e);
        } catch (ScriptException e) {
            throw new BotException(e.mistake().in(title), e);
        }
    }

    /** Reports each mistake once, as for a script; the answer contains their number. */
    private void refuse(List<Mistake> mistakes, Stage here) {
        Mistake.inOrder(mistakes, title).forEach(mistake -> here.line.send(Line.Kind.ERROR, mistake));
        if (!mistakes.isEmpty()) {
            throw new BotException(Mistake.counted(mistakes.size()) + " in it, nothing was run");
        }
    }
}
