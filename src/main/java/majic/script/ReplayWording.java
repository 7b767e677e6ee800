package majic.script;

import java.nio.file.Path;
import java.util.Set;
import majic.act.Acts;
import majic.script.syntax.Command;
import majic.script.syntax.Literal;
import majic.script.syntax.Wording;

/** How a saved session repeats what was typed: with the robots' numbers, and files that are found from everywhere. */
final class ReplayWording {
    private ReplayWording() {}

    /**
     * A command for robots.
     *
     * @param typed whether a person at a prompt gave it, for whom a reading was taken at once
     * @param acts finds the files of behaviours
     * @return empty if there is nothing to repeat
     */
    static String of(Command command, Set<Integer> robots, boolean typed, Acts acts) {
        return command instanceof Command.Help
                ? ""
                : ReplayScript.numbers(robots) + " " + Wording.of(repeated(command, typed, acts));
    }

    private static Command repeated(Command command, boolean typed, Acts acts) {
        if (typed && command instanceof Command.Get get) {
            return new Command.Get(get.at(), get.parameters(), true);
        }
        if (command instanceof Command.Act act) {
            String name = SessionCheck.text(act.name());
            if (Acts.isFile(name)) {
                Path found = acts.locate(name).orElseThrow();
                Literal file = new Literal(act.name().at(), act.name().value(), absolute(found));
                return new Command.Act(act.at(), file, act.others());
            }
        }
        return command;
    }

    /** A file that is run as a script. */
    static String run(Path file) {
        return "run " + absolute(file);
    }

    private static String absolute(Path file) {
        return SessionRecord.quoted(file.toAbsolutePath().toString());
    }
}
