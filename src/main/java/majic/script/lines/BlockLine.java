package majic.script.lines;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import majic.bot.BotException;
import majic.script.conditions.Selection;
import majic.script.run.ActionLookup;
import majic.script.run.Checker;
import majic.script.run.Execution;
import majic.script.run.Interpreter;
import majic.script.run.RobotsIn;
import majic.script.run.ScriptExecution;
import majic.script.syntax.CommandTrait;
import majic.script.syntax.Mistake;
import majic.script.syntax.Statement;

/** A block; its commands are checked again when they run, since a loop or a condition may change what is true now. */
final class BlockLine extends PreparedLine {
    private final Statement block;

    BlockLine(Statement block, String text, RobotsIn robots) {
        super(text, block.scheduling(), traits(robots), List.copyOf(robots.commanded()), List.of());
        this.block = block;
        markChecked();
    }

    private static Set<CommandTrait> traits(RobotsIn robots) {
        Set<CommandTrait> traits = EnumSet.of(CommandTrait.COMMANDS_ROBOTS, CommandTrait.CHANGES_TEAM);
        if (robots.readsFiles()) {
            traits.add(CommandTrait.READS_FILES);
        }
        return traits;
    }

    @Override
    Statement statement() {
        return block;
    }

    @Override
    void check(ActionLookup actions, Selection selection) {
        requireNone(Checker.checkWithoutFiles(List.of(block), actions, selection));
    }

    @Override
    void checkWithFiles(ActionLookup actions, Selection selection) {
        requireNone(Checker.check(List.of(block), actions, selection));
    }

    @Override
    void run(Execution execution, ActionLookup actions) {
        boolean waits = execution.isTyped();
        ScriptExecution script = execution.asScript(title(), text().strip(), waits);
        if (!script.run(List.of(block), new Interpreter(script, actions)::run, title(), "", waits)) {
            execution.fail(title());
        }
    }

    @Override
    void waits() {}

    private static void requireNone(List<Mistake> mistakes) {
        if (!mistakes.isEmpty()) {
            throw new BotException(mistakes.get(0).message());
        }
    }
}
