package majic.script.lines;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.script.conditions.Selection;
import majic.script.run.Actions;
import majic.script.run.Checker;
import majic.script.run.Execution;
import majic.script.run.RobotAction;
import majic.script.run.RobotCheck;
import majic.script.run.RobotsIn;
import majic.script.run.Scheduling;
import majic.script.run.SessionAction;
import majic.script.run.SessionCheck;
import majic.script.run.Trait;
import majic.script.syntax.Mistake;
import majic.script.syntax.Statement;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** Resolves the commands and robots of a line and checks it, once: when it is typed, or when the files it names are read. */
final class LinePreparation {
    private final Actions actions;
    private final Selection selection;

    LinePreparation(Actions actions, Selection selection) {
        this.actions = actions;
        this.selection = selection;
    }

    /**
     * Prepares a line. Reads no file and never waits.
     *
     * @param check whether it can be checked now; if not, as before a change of the team, it is checked in its turn
     * @throws BotException if it cannot be done
     * @throws majic.script.syntax.ScriptException if it cannot be done with the robots that are there
     */
    PreparedLine prepare(Statement statement, String text, boolean check) {
        if (statement instanceof Statement.ForRobots line) {
            return forRobots(line, text, check);
        }
        return statement instanceof Statement.ForSession line
                ? forSession(line, text, check)
                : block(statement, text, check);
    }

    /**
     * Checks a line with the files that it names. Reads them, so it may block.
     *
     * @return runs the line without another check; null for a block, which is checked again when it runs
     * @throws BotException if the line cannot be run
     * @throws majic.script.syntax.ScriptException if it cannot be run with the robots that are there
     */
    @Nullable
    Consumer<Execution> checkWithFiles(PreparedLine line) {
        if (line.statement() instanceof Statement.ForRobots robotLine) {
            RobotAction action = actions.of(robotLine.command());
            List<Member> robots = selection.members(robotLine.robots());
            robots.forEach(robot -> action.check(new RobotCheck(selection, robot, false, true)));
            return execution -> execution.run(action, robots);
        }
        if (line.statement() instanceof Statement.ForSession sessionLine) {
            SessionAction action = actions.of(sessionLine.command());
            action.check(new SessionCheck(selection, false));
            return action::run;
        }
        refuse(Checker.check(List.of(line.statement()), actions, selection));
        return null;
    }

    private PreparedLine forRobots(Statement.ForRobots line, String text, boolean check) {
        RobotAction action = actions.of(line.command());
        List<Member> robots = check ? selection.members(line.robots()) : selection.present(line.robots());
        if (check) {
            robots.forEach(robot -> action.check(new RobotCheck(selection, robot, false, false)));
        }
        Consumer<Execution> run = execution -> execution.run(action, robots);
        return new PreparedLine(
                line, text, action.scheduling(), action.traits(), robots, onceChecked(check, action.traits(), run));
    }

    private PreparedLine forSession(Statement.ForSession line, String text, boolean check) {
        SessionAction action = actions.of(line.command());
        if (check && !action.has(Trait.READS_FILES)) {
            action.check(new SessionCheck(selection, false));
        }
        return new PreparedLine(
                line,
                text,
                action.scheduling(),
                action.traits(),
                List.of(),
                onceChecked(check, action.traits(), action::run));
    }

    private static @Nullable Consumer<Execution> onceChecked(
            boolean check, Set<Trait> traits, Consumer<Execution> run) {
        return check && !traits.contains(Trait.READS_FILES) ? run : null;
    }

    /** What of a block runs later is checked again then, since a loop or a condition may change what is true now. */
    private PreparedLine block(Statement block, String text, boolean check) {
        if (check) {
            checkBlock(block);
        }
        RobotsIn robots = RobotsIn.of(List.of(block), actions, selection);
        Set<Trait> traits = EnumSet.of(Trait.COMMANDS_ROBOTS, Trait.CHANGES_TEAM);
        if (robots.readsFiles()) {
            traits.add(Trait.READS_FILES);
        }
        return new PreparedLine(block, text, Scheduling.BESIDE, traits, List.copyOf(robots.commanded()), null);
    }

    /** Checks a block, or only its head. */
    void checkBlock(Statement block) {
        refuse(Checker.checkWithoutFiles(List.of(block), actions, selection));
    }

    private static void refuse(List<Mistake> mistakes) {
        if (!mistakes.isEmpty()) {
            throw new BotException(mistakes.get(0).message());
        }
    }

    /** When a statement runs. */
    Scheduling scheduling(Statement statement) {
        if (statement instanceof Statement.ForRobots line) {
            return actions.of(line.command()).scheduling();
        }
        return statement instanceof Statement.ForSession line
                ? actions.of(line.command()).scheduling()
                : Scheduling.BESIDE;
    }
}
