package majic.script.acts;

import java.util.Optional;
import majic.script.syntax.Command;
import majic.script.syntax.SessionCommand;

/**
 * Which commands a behaviour may contain; of {@code add} only the form with a number. Each method returns the reason
 * why a command is refused, empty if it is allowed. A command without a rule does not compile.
 */
final class ScriptActRules implements Command.Visitor<Optional<String>>, SessionCommand.Visitor<Optional<String>> {
    private static final Optional<String> ALLOWED = Optional.empty();
    private static final Optional<String> OTHER_ACT = Optional.of("an act does not run others");
    private static final Optional<String> HELP = Optional.of("an act needs none; leave the line out");
    private static final Optional<String> FOR_SESSION =
            Optional.of("is for a session; an act only commands the robots it is given");

    @Override
    public Optional<String> move(Command.Move move) {
        return ALLOWED;
    }

    @Override
    public Optional<String> turn(Command.Turn turn) {
        return ALLOWED;
    }

    @Override
    public Optional<String> drive(Command.Drive drive) {
        return ALLOWED;
    }

    @Override
    public Optional<String> stop(Command.Stop stop) {
        return ALLOWED;
    }

    @Override
    public Optional<String> get(Command.Get get) {
        return ALLOWED;
    }

    @Override
    public Optional<String> set(Command.Set set) {
        return ALLOWED;
    }

    @Override
    public Optional<String> log(Command.Log log) {
        return ALLOWED;
    }

    @Override
    public Optional<String> logOff(Command.LogOff logOff) {
        return ALLOWED;
    }

    @Override
    public Optional<String> plot(Command.Plot plot) {
        return ALLOWED;
    }

    @Override
    public Optional<String> name(Command.Name name) {
        return ALLOWED;
    }

    @Override
    public Optional<String> place(Command.Place place) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> act(Command.Act act) {
        return OTHER_ACT;
    }

    @Override
    public Optional<String> actOff(Command.ActOff actOff) {
        return OTHER_ACT;
    }

    @Override
    public Optional<String> await(Command.Await await) {
        return ALLOWED;
    }

    @Override
    public Optional<String> help(Command.Help help) {
        return HELP;
    }

    @Override
    public Optional<String> own(Command.Own own) {
        return ALLOWED;
    }

    @Override
    public Optional<String> add(SessionCommand.Add add) {
        return ALLOWED;
    }

    @Override
    public Optional<String> remove(SessionCommand.Remove remove) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> bots(SessionCommand.Bots bots) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> probe(SessionCommand.Probe probe) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> acts(SessionCommand.Acts acts) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> consents(SessionCommand.Consents consents) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> trust(SessionCommand.Trust trust) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> trustOff(SessionCommand.TrustOff trustOff) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> release(SessionCommand.Release release) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> run(SessionCommand.Run run) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> saveSession(SessionCommand.SaveSession save) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> saveLog(SessionCommand.SaveLog save) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> saveTeam(SessionCommand.SaveTeam save) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> lab(SessionCommand.Lab lab) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> help(SessionCommand.Help help) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> quit(SessionCommand.Quit quit) {
        return FOR_SESSION;
    }

    @Override
    public Optional<String> stopAll(SessionCommand.StopAll stop) {
        return ALLOWED;
    }

    @Override
    public Optional<String> await(SessionCommand.Await await) {
        return ALLOWED;
    }

    @Override
    public Optional<String> pause(SessionCommand.Pause pause) {
        return ALLOWED;
    }
}
