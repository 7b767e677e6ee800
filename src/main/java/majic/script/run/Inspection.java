package majic.script.run;

import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;
import majic.script.syntax.Condition;
import majic.script.syntax.Mistake;
import majic.script.syntax.ScriptException;

/** Goes through a script and collects all that is wrong in it, instead of ending with the first mistake. */
public abstract class Inspection extends StatementWalk {
    private final List<Mistake> mistakes = new ArrayList<>();

    /** What is wrong so far, in its order. */
    public final List<Mistake> mistakes() {
        return mistakes;
    }

    /**
     * Looks at the condition of a block.
     *
     * @throws ScriptException if it is wrong; the block behind it is looked at all the same
     */
    public abstract void inspect(Condition condition);

    @Override
    public final void visit(Statement statement) {
        try {
            super.visit(statement);
        } catch (ScriptException e) {
            mistakes.add(e.mistake());
        } catch (BotException e) {
            mistakes.add(new ScriptException(statement.at(), String.valueOf(e.getMessage())).mistake());
        }
    }

    @Override
    public final void head(Condition condition) {
        try {
            inspect(condition);
        } catch (ScriptException e) {
            mistakes.add(e.mistake());
        }
    }
}
