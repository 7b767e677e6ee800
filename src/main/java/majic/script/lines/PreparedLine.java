package majic.script.lines;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import majic.bot.BotException;
import majic.driver.Permit;
import majic.script.commands.ScriptParser;
import majic.script.conditions.Selection;
import majic.script.run.Checker;
import majic.script.run.Command;
import majic.script.run.CommandTrait;
import majic.script.run.Execution;
import majic.script.run.LiveValues;
import majic.script.run.RobotsIn;
import majic.script.run.Scheduling;
import majic.script.run.Scope;
import majic.script.run.ScriptExecution;
import majic.script.run.SessionCommand;
import majic.script.run.SessionState;
import majic.script.run.Statement;
import majic.script.run.Types;
import majic.script.syntax.Mistake;
import majic.script.syntax.Operand;
import majic.team.Member;

/**
 * A line or block, from when it was typed until it has run: its robots are resolved, and it is checked once. Where that
 * is not possible when it is typed, because it waits or names files, it is checked in its turn. The commands of a block
 * are checked again when they run, since a loop or a condition may change what is true now.
 */
public final class PreparedLine {
    private final SessionState session;
    private final Selection selection;
    private final Scope<Operand> names;
    private final Statement statement;

    /** The same, as far as it is known before it runs. */
    private final Statement sample;

    private final Scheduling scheduling;
    private final String text;
    private final Collection<CommandTrait> traits;
    private final Map<Member, Permit> permits = new HashMap<>();
    private final Set<Integer> commanded;
    private List<Member> robots;
    private boolean isChecked;
    private boolean stopSent;
    private long stops;
    private Consumer<RuntimeException> refused = why -> {};
    private Consumer<String> failed = why -> {};

    private PreparedLine(
            SessionState session,
            Selection selection,
            Scope<Operand> names,
            Statement statement,
            Statement sample,
            String text,
            Collection<CommandTrait> traits,
            List<Member> robots) {
        this.session = session;
        this.selection = selection;
        this.names = names;
        this.statement = statement;
        this.sample = sample;
        this.scheduling = statement.scheduling();
        this.text = text;
        this.traits = traits;
        this.robots = robots;
        if (has(CommandTrait.COMMANDS_ROBOTS)) {
            robots.forEach(robot -> permits.put(robot, robot.currentPermit()));
            if (sample instanceof Statement.ForRobots line) {
                selection.present(line.command().others()).forEach(robot -> permits.put(robot, robot.currentPermit()));
            }
        }
        commanded = permits.keySet().stream().map(Member::number).collect(Collectors.toSet());
    }

    /**
     * Resolves a line and takes the permissions to move the robots that it commands. Reads no file and never waits.
     *
     * @param names what is known of the names that it may use; a name that it makes is added when it is checked
     * @param complete whether all robots that it names by number have to be there; if not, those are left out that are
     *     not there
     * @throws majic.script.syntax.ScriptException if robots have to be there and are not
     */
    static PreparedLine of(
            Statement statement,
            String text,
            SessionState session,
            Selection selection,
            Scope<Operand> names,
            boolean complete) {
        Statement sample = statement instanceof Statement.Computed computed
                ? computed.line().sample()
                : statement;
        if (sample instanceof Statement.ForRobots line) {
            List<Member> robots = complete ? selection.members(line.robots()) : selection.present(line.robots());
            return new PreparedLine(
                    session,
                    selection,
                    names,
                    statement,
                    sample,
                    text,
                    line.command().traits(),
                    robots);
        }
        if (sample instanceof Statement.ForSession line) {
            return new PreparedLine(
                    session,
                    selection,
                    names,
                    statement,
                    sample,
                    text,
                    line.command().traits(),
                    List.of());
        }
        RobotsIn block = RobotsIn.of(List.of(statement), selection);
        return new PreparedLine(
                session, selection, names, statement, sample, text, traits(block), List.copyOf(block.commanded()));
    }

    /** The line as far as it is known now: of a name or a reading the kind of its value. */
    private Statement known() {
        return statement instanceof Statement.Computed computed
                ? computed.line().with(new Types(selection, names))
                : statement;
    }

    private static Set<CommandTrait> traits(RobotsIn block) {
        Set<CommandTrait> traits = EnumSet.of(CommandTrait.COMMANDS_ROBOTS, CommandTrait.CHANGES_TEAM);
        if (block.readsFiles()) {
            traits.add(CommandTrait.READS_FILES);
        }
        return traits;
    }

    /**
     * Checks the line when it is typed, without its files.
     *
     * @throws BotException if it cannot be done
     * @throws majic.script.syntax.ScriptException if it cannot be done with the robots that are there
     */
    void check() {
        boolean readsFiles = has(CommandTrait.READS_FILES);
        Statement known = known();
        if (known instanceof Statement.ForRobots line) {
            check(line.command(), false);
            isChecked = !readsFiles;
        } else if (known instanceof Statement.ForSession line) {
            if (!readsFiles) {
                check(line.command());
            }
        } else {
            requireNone(Checker.check(List.of(statement), session, selection, names, false));
        }
    }

    /** Checks the line in its turn, with its files, so it may block; throws as {@link #check}. */
    void checkWithFiles() {
        Statement known = known();
        if (known instanceof Statement.ForRobots line) {
            robots = selection.members(line.robots());
            check(line.command(), true);
            isChecked = true;
        } else if (known instanceof Statement.ForSession line) {
            check(line.command());
        } else {
            requireNone(Checker.check(List.of(statement), session, selection, names, true));
        }
    }

    private void check(Command command, boolean readsFiles) {
        command.check(robots.stream()
                .map(robot -> new Command.Check(session, selection, robot, false, readsFiles))
                .toList());
    }

    private void check(SessionCommand command) {
        command.check(new SessionCommand.Check(session, selection, false));
        isChecked = true;
    }

    private static void requireNone(List<Mistake> mistakes) {
        if (!mistakes.isEmpty()) {
            throw new BotException(mistakes.get(0).message());
        }
    }

    /** Sets that the line waits: other robots may be there when its turn comes, so it has to be checked again. */
    void waits() {
        isChecked = false;
    }

    /** Runs the line; checks it first if it was not checked just now. */
    void run(Execution execution) {
        if (!isChecked) {
            execution.checkAlive();
            if (!statement.isBlock()) {
                checkWithFiles();
            }
        }
        if (statement.isBlock()) {
            runBlock(execution);
        } else if (statement instanceof Statement.Computed line) {
            run(execution, line.line().with(LiveValues.ofLine(execution, sample)));
        } else {
            run(execution, statement);
        }
    }

    private void run(Execution execution, Statement line) {
        if (line instanceof Statement.ForRobots forRobots) {
            if (line != statement) {
                check(forRobots.command(), true);
            }
            forRobots.command().perform(execution, robots);
        } else if (line instanceof Statement.ForSession forSession) {
            if (line != statement) {
                check(forSession.command());
            }
            forSession.command().run(execution);
        }
    }

    private void runBlock(Execution execution) {
        boolean waits = execution.isTyped();
        ScriptExecution script =
                ScriptExecution.ofLine(execution, title(), text.strip(), waits, execution.scope(), isAlone(), null);
        if (!script.run(List.of(statement), title(), "", waits)) {
            execution.fail(title());
        }
    }

    /** Whether the block names no value and calls no procedure of other lines. */
    private boolean isAlone() {
        List<String> robotWords = new ArrayList<>(selection.names());
        session.factory().types().forEach(type -> robotWords.add(type.name()));
        List<Mistake> missing = new ArrayList<>();
        ScriptParser.parse(text, robotWords, missing);
        return missing.isEmpty();
    }

    /** Sets how often the robots that it commands had been stopped when it was typed. */
    void typedAfter(long stopCount) {
        stops = stopCount;
    }

    /** How often the robots that it commands had been stopped when it was typed. */
    long stopsBefore() {
        return stops;
    }

    /**
     * Sets what receives the reason if the line is not run.
     *
     * @param byFiles receives the exception if its files do not let it be done
     * @param inTurn receives a sentence if the session or a robot refuses it when its turn comes
     */
    void reportTo(Consumer<RuntimeException> byFiles, Consumer<String> inTurn) {
        refused = byFiles;
        failed = inTurn;
    }

    void refuse(RuntimeException why) {
        refused.accept(why);
    }

    void fail(String why) {
        failed.accept(why);
    }

    /** Marks a stop as sent, so that in its turn only its end is waited for. */
    void markStopSent() {
        stopSent = true;
    }

    boolean isStopSent() {
        return stopSent;
    }

    /** Whether it has other lines in it. */
    boolean isBlock() {
        return statement.isBlock();
    }

    /** When it runs. */
    Scheduling scheduling() {
        return scheduling;
    }

    /** Whether one of its commands has a trait. */
    public boolean has(CommandTrait trait) {
        return traits.contains(trait);
    }

    /**
     * The robots that it is for; of a block those that it commands. As far as they were in the team when it was typed.
     */
    List<Member> robots() {
        return robots;
    }

    /** The numbers of the robots it makes do something. */
    Set<Integer> commanded() {
        return commanded;
    }

    /** For each robot that it commands, the permission to move that was in force when it was typed. */
    Map<Member, Permit> permits() {
        return permits;
    }

    /** Its first line, as answers call it. */
    String title() {
        return text.strip().lines().findFirst().orElse("").replaceAll("\\s+", " ");
    }
}
