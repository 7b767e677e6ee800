package majic.script.run;

import java.util.List;
import java.util.function.Function;
import majic.script.syntax.Literal;
import majic.team.Member;
import majic.team.QueuedCommand;

/** Finds behaviours, runs them on robots and keeps the consent to their code. */
public interface ActRunner {
    /**
     * Finds a behaviour, and reads and checks its file. May block.
     *
     * @throws majic.script.syntax.ScriptException if there is none, or it cannot be loaded
     */
    CheckedAct read(ActCall call);

    /** A behaviour whose file was read once and checked; each run of it is a new act. */
    interface CheckedAct {
        /**
         * Checks whether it can be loaded onto a robot.
         *
         * @throws majic.script.syntax.ScriptException if not
         */
        void check(Command.Check check);

        /**
         * Takes the permissions to move its further robots: a stop of one of them from now on prevents or ends it.
         *
         * @return for a robot, the command that runs it in the robot's turn and lasts as long as it does
         */
        Function<Member, QueuedCommand> commands(Execution execution);
    }

    /**
     * Ends the behaviour that a robot runs or has a role in; one that is queued ends when its turn comes.
     *
     * @return a command that answers once the robot is free
     */
    QueuedCommand callOff(Member member);

    /** The name with which a saved session repeats a behaviour: a file by its absolute path. */
    String replayName(Literal name);

    /** One line for each behaviour that needs no path. */
    List<String> list();

    /**
     * Describes a behaviour, the robots it needs and its arguments.
     *
     * @throws majic.bot.BotException if there is none of that name, or it cannot be one
     */
    List<String> describe(String name);

    /**
     * Describes what code a behaviour brings; with the beginning of its hash, agrees to that file.
     *
     * @param hash empty to be shown only
     */
    List<String> trust(String name, String hash);

    /** One line for each file to whose code the user has agreed. */
    List<String> consents();

    /** Takes the consent to a file back. */
    String trustOff(String nameOrHash);

    /**
     * Checks that a behaviour can be found.
     *
     * @throws majic.bot.BotException if not
     */
    void checkNamed(String name);

    /**
     * Checks that a file can be found, by its name or hash.
     *
     * @throws majic.bot.BotException if not
     */
    void checkHash(String nameOrHash);
}
