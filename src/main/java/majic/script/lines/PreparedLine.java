package majic.script.lines;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.driver.Permit;
import majic.script.conditions.Selection;
import majic.script.run.ActionLookup;
import majic.script.run.Execution;
import majic.script.run.Interpreter;
import majic.script.run.RobotAction;
import majic.script.run.RobotsIn;
import majic.script.syntax.CommandTrait;
import majic.script.syntax.Scheduling;
import majic.script.syntax.Statement;
import majic.team.Member;

/**
 * A line or block, from when it was typed until it has run: its commands and robots are resolved, and it is checked
 * once. Where that is not possible when it is typed, because it waits or names files, it is checked in its turn.
 */
public abstract class PreparedLine {
    private final String text;
    private final Scheduling scheduling;
    private final Collection<CommandTrait> traits;
    private List<Member> robots;
    private final Map<Member, Permit> permits = new HashMap<>();
    private final Set<Integer> commanded;
    private boolean isChecked;
    private boolean stopSent;
    private long stops;
    private Consumer<RuntimeException> refused = why -> {};
    private Consumer<String> failed = why -> {};

    /**
     * A line; takes the permissions to move its robots if it commands them.
     *
     * @param robots those it is for; of a block those that it commands
     * @param others further robots that it commands
     */
    PreparedLine(
            String text,
            Scheduling scheduling,
            Collection<CommandTrait> traits,
            List<Member> robots,
            List<Member> others) {
        this.text = text;
        this.scheduling = scheduling;
        this.traits = traits;
        this.robots = robots;
        if (has(CommandTrait.COMMANDS_ROBOTS)) {
            Stream.concat(robots.stream(), others.stream()).forEach(robot -> permits.put(robot, robot.currentPermit()));
        }
        commanded = permits.keySet().stream().map(Member::number).collect(Collectors.toSet());
    }

    /**
     * Resolves a line and takes the permissions to move its robots. Reads no file and never waits.
     *
     * @param complete whether all robots that it names by number have to be there; if not, those are left out that are
     *     not there
     * @throws majic.script.syntax.ScriptException if robots have to be there and are not
     */
    static PreparedLine of(
            Statement statement, String text, ActionLookup actions, Selection selection, boolean complete) {
        if (statement instanceof Statement.ForRobots line) {
            List<Member> robots = complete ? selection.members(line.robots()) : selection.present(line.robots());
            return new RobotLine(line, text, actions.of(line.command()), robots, selection);
        }
        return statement instanceof Statement.ForSession line
                ? new SessionLine(line, text, actions.of(line.command()))
                : new BlockLine(statement, text, RobotsIn.of(List.of(statement), selection));
    }

    /**
     * Checks the line when it is typed, without its files.
     *
     * @throws BotException if it cannot be done
     * @throws majic.script.syntax.ScriptException if it cannot be done with the robots that are there
     */
    abstract void check(ActionLookup actions, Selection selection);

    /** Checks the line in its turn, with its files, so it may block; throws as {@link #check}. */
    abstract void checkWithFiles(ActionLookup actions, Selection selection);

    /** Sets that {@link #run} needs no other check. */
    final void markChecked() {
        isChecked = true;
    }

    /** Runs the line; checks it first if it was not checked just now. */
    final void runChecked(Execution execution, ActionLookup actions) {
        if (isChecked) {
            execution.checkAlive();
            run(execution, actions);
        } else {
            new Interpreter(execution, actions).run(List.of(statement()));
        }
    }

    /** Runs the line as it was resolved and checked. */
    abstract void run(Execution execution, ActionLookup actions);

    /** Sets that the line waits: other robots may be there when its turn comes, so it has to be checked again. */
    void waits() {
        isChecked = false;
    }

    /** Sets how often the robots that it commands had been stopped when it was typed. */
    final void typedAfter(long stopCount) {
        stops = stopCount;
    }

    /** How often the robots that it commands had been stopped when it was typed. */
    final long stopsBefore() {
        return stops;
    }

    /**
     * Sets what receives the reason if the line is not run.
     *
     * @param byFiles receives the exception if its files do not let it be done
     * @param inTurn receives a sentence if the session or a robot refuses it when its turn comes
     */
    final void reportTo(Consumer<RuntimeException> byFiles, Consumer<String> inTurn) {
        refused = byFiles;
        failed = inTurn;
    }

    final void refuse(RuntimeException why) {
        refused.accept(why);
    }

    final void fail(String why) {
        failed.accept(why);
    }

    /** Marks a stop as sent, so that in its turn only its end is waited for. */
    final void markStopSent() {
        stopSent = true;
    }

    final boolean isStopSent() {
        return stopSent;
    }

    abstract Statement statement();

    /** When it runs. */
    final Scheduling scheduling() {
        return scheduling;
    }

    /** Whether one of its commands has a trait. */
    public final boolean has(CommandTrait trait) {
        return traits.contains(trait);
    }

    /**
     * The robots that it is for; of a block those that it commands. As far as they were in the team when it was typed.
     */
    final List<Member> robots() {
        return robots;
    }

    /** Sets the robots that it is for, as found in its turn. */
    final void useRobots(List<Member> found) {
        robots = found;
    }

    /** The numbers of the robots it makes do something. */
    final Set<Integer> commanded() {
        return commanded;
    }

    /** For each robot that it commands, the permission to move that was in force when it was typed. */
    final Map<Member, Permit> permits() {
        return permits;
    }

    /** The lines of text as they were typed. */
    final String text() {
        return text;
    }

    /** Its first line, as answers call it. */
    final String title() {
        return text.strip().lines().findFirst().orElse("").replaceAll("\\s+", " ");
    }

    /** A command for robots. */
    private static final class RobotLine extends PreparedLine {
        private final Statement.ForRobots line;
        private final RobotAction action;

        RobotLine(Statement.ForRobots line, String text, RobotAction action, List<Member> robots, Selection selection) {
            super(
                    text,
                    line.scheduling(),
                    line.command().traits(),
                    robots,
                    selection.present(line.command().others()));
            this.line = line;
            this.action = action;
        }

        @Override
        Statement statement() {
            return line;
        }

        @Override
        void check(ActionLookup actions, Selection selection) {
            action.check(checks(selection, false));
            if (!has(CommandTrait.READS_FILES)) {
                markChecked();
            }
        }

        private List<RobotAction.Check> checks(Selection selection, boolean readsFiles) {
            return robots().stream()
                    .map(robot -> new RobotAction.Check(selection, robot, false, readsFiles))
                    .toList();
        }

        @Override
        void checkWithFiles(ActionLookup actions, Selection selection) {
            useRobots(selection.members(line.robots()));
            action.check(checks(selection, true));
            markChecked();
        }

        @Override
        void run(Execution execution, ActionLookup actions) {
            execution.run(action, robots());
        }
    }
}
