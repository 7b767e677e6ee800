package majic.script.actions;

import majic.log.ParameterLog;
import majic.log.Sampling;
import majic.script.run.ActRunner;
import majic.script.run.ActionLookup;
import majic.script.run.RobotAction;
import majic.script.run.ScriptFiles;
import majic.script.run.SessionAction;
import majic.script.run.SessionState;
import majic.script.syntax.Command;
import majic.script.syntax.SessionCommand;
import majic.team.BotFactory;

/**
 * Creates the action for each command and passes it what it needs. The compiler refuses a command without an action.
 *
 * @param state the team, the output and the record of the session
 * @param factory makes robots
 * @param connector adds and removes robots
 * @param acts runs behaviours
 * @param parameterLog the readings logged so far
 * @param sampling takes readings for the log
 * @param plotting shows plots
 * @param quit ends MAJIC; returns at once
 */
public record ActionTable(
        SessionState state,
        BotFactory factory,
        RobotConnector connector,
        ActRunner acts,
        ParameterLog parameterLog,
        Sampling sampling,
        Plotting plotting,
        Runnable quit)
        implements ActionLookup, Command.Visitor<RobotAction>, SessionCommand.Visitor<SessionAction> {
    @Override
    public RobotAction of(Command command) {
        return command.accept(this);
    }

    @Override
    public SessionAction of(SessionCommand command) {
        return command.accept(this);
    }

    @Override
    public RobotAction move(Command.Move move) {
        return new MotionActions.MoveAction(move);
    }

    @Override
    public RobotAction turn(Command.Turn turn) {
        return new MotionActions.TurnAction(turn);
    }

    @Override
    public RobotAction drive(Command.Drive drive) {
        return new MotionActions.DriveAction(drive);
    }

    @Override
    public RobotAction stop(Command.Stop stop) {
        return new MotionActions.StopAction(stop);
    }

    @Override
    public RobotAction get(Command.Get get) {
        return new ParameterActions.GetAction(get);
    }

    @Override
    public RobotAction set(Command.Set set) {
        return new ParameterActions.SetAction(set);
    }

    @Override
    public RobotAction log(Command.Log log) {
        return new ParameterActions.LogAction(log, sampling);
    }

    @Override
    public RobotAction logOff(Command.LogOff logOff) {
        return new ParameterActions.LogOffAction(logOff, sampling);
    }

    @Override
    public RobotAction plot(Command.Plot plot) {
        return new ParameterActions.PlotAction(plot, plotting);
    }

    @Override
    public RobotAction name(Command.Name name) {
        return new TeamActions.NameAction(name, state.team(), factory);
    }

    @Override
    public RobotAction place(Command.Place place) {
        return new LabActions.PlaceAction(place, factory);
    }

    @Override
    public RobotAction act(Command.Act act) {
        return new ActActions.ActAction(act, acts, this);
    }

    @Override
    public RobotAction actOff(Command.ActOff actOff) {
        return new ActActions.ActOffAction(actOff, acts);
    }

    @Override
    public RobotAction await(Command.Await await) {
        return new WaitActions.WaitForRobotsAction(await);
    }

    @Override
    public RobotAction help(Command.Help help) {
        return new HelpActions.RobotHelpAction(help);
    }

    @Override
    public RobotAction own(Command.Own own) {
        return new ParameterActions.OwnAction(own);
    }

    @Override
    public SessionAction add(SessionCommand.Add add) {
        return new TeamActions.AddAction(add, connector, factory);
    }

    @Override
    public SessionAction remove(SessionCommand.Remove remove) {
        return new TeamActions.RemoveAction(remove, connector);
    }

    @Override
    public SessionAction bots(SessionCommand.Bots bots) {
        return new TeamActions.BotsAction(state.team(), connector);
    }

    @Override
    public SessionAction probe(SessionCommand.Probe probe) {
        return new TeamActions.ProbeAction(probe, connector, factory);
    }

    @Override
    public SessionAction acts(SessionCommand.Acts command) {
        return new ActActions.ActsAction(command, acts);
    }

    @Override
    public SessionAction consents(SessionCommand.Consents consents) {
        return new ActActions.ConsentsAction(acts);
    }

    @Override
    public SessionAction trust(SessionCommand.Trust trust) {
        return new ActActions.TrustAction(trust, acts);
    }

    @Override
    public SessionAction trustOff(SessionCommand.TrustOff trustOff) {
        return new ActActions.TrustOffAction(trustOff, acts);
    }

    @Override
    public SessionAction release(SessionCommand.Release release) {
        return new TeamActions.ReleaseAction(state.team());
    }

    @Override
    public SessionAction run(SessionCommand.Run run) {
        return new FileActions.RunAction(run, new ScriptFiles(factory, this));
    }

    @Override
    public SessionAction saveSession(SessionCommand.SaveSession save) {
        return new FileActions.SaveSessionAction(save, state.record());
    }

    @Override
    public SessionAction saveLog(SessionCommand.SaveLog save) {
        return new FileActions.SaveLogAction(save, parameterLog);
    }

    @Override
    public SessionAction saveTeam(SessionCommand.SaveTeam save) {
        return new FileActions.SaveTeamAction(save, new TeamScript(state.team(), factory, connector));
    }

    @Override
    public SessionAction lab(SessionCommand.Lab lab) {
        return new LabActions.LabAction(factory);
    }

    @Override
    public SessionAction help(SessionCommand.Help help) {
        return new HelpActions.LanguageHelpAction(help, factory, state.team());
    }

    @Override
    public SessionAction quit(SessionCommand.Quit command) {
        return new HelpActions.QuitAction(quit);
    }

    @Override
    public SessionAction stopAll(SessionCommand.StopAll stop) {
        return new TeamActions.StopAllAction();
    }

    @Override
    public SessionAction await(SessionCommand.Await await) {
        return new WaitActions.WaitForAllAction();
    }

    @Override
    public SessionAction pause(SessionCommand.Pause pause) {
        return new WaitActions.PauseAction(pause);
    }
}
