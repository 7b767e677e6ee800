package majic.script;

import java.util.List;
import java.util.OptionalInt;

/**
 * A script as a behaviour of one robot, which it calls {@code me}. Immutable.
 *
 * @param name what messages call it
 * @param text the script, its lines apart by line breaks
 */
public record ScriptBehaviour(String name, String text) {
    /**
     * Runs it, and blocks until it has ended: by itself, by a failure, or by a stop of a robot it uses. The session's
     * listeners hear how.
     *
     * @param session whose team is commanded
     * @param me the number of the robot that is {@code me}
     * @return whether it came to its end
     */
    public boolean run(Session session, int me) {
        Execution execution = Execution.ofScript(session, name, new Tally(), OptionalInt.of(me));
        try {
            List<Statement> script = ScriptRun.parse(name, text, session, execution.selection());
            return new ScriptRun(execution, me + " " + name, name, true).run(script);
        } catch (ExecutionEnded e) {
            session.say(Line.Kind.ANSWER, me + " " + name + ": " + e.ending());
            return false;
        }
    }
}
