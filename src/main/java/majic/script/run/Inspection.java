package majic.script.run;

import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;
import majic.script.syntax.Condition;
import majic.script.syntax.Late;
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
    public abstract void inspect(Late<Condition> condition);

    @Override
    public final void visit(Statement statement) {
        try {
            super.visit(statement);
        } catch (ScriptException e) {
            add(e.mistake());
        } catch (BotException e) {
            add(new ScriptException(statement.at(), String.valueOf(e.getMessage())).mistake());
        }
    }

    @Override
    public final void head(Late<Condition> condition) {
        try {
            inspect(condition);
        } catch (ScriptException e) {
            add(e.mistake());
        }
    }

    /** A procedure that is called several times has its mistakes once. */
    private void add(Mistake mistake) {
        if (!mistakes.contains(mistake)) {
            mistakes.add(mistake);
        }
    }
}
