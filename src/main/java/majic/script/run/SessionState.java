package majic.script.run;

import majic.log.ParameterLog;
import majic.log.Sampling;
import majic.log.SessionOutput;
import majic.nav.CurrentMap;
import majic.script.record.SessionRecord;
import majic.team.BotFactory;
import majic.team.Team;

/**
 * What all lines of a session share, and its commands use.
 *
 * @param team the robots
 * @param output where answers go
 * @param record what was done so far
 * @param factory makes robots
 * @param connector adds and removes robots
 * @param acts runs behaviours
 * @param parameterLog the readings logged so far
 * @param sampling takes readings for the log
 * @param plotting shows plots
 * @param map of the team
 * @param questions of scripts that wait for an answer
 * @param random of all scripts
 * @param quit ends MAJIC; returns at once
 */
public record SessionState(
        Team team,
        SessionOutput output,
        SessionRecord record,
        BotFactory factory,
        RobotConnector connector,
        ActRunner acts,
        ParameterLog parameterLog,
        Sampling sampling,
        Plotting plotting,
        CurrentMap map,
        Questions questions,
        RandomNumbers random,
        Runnable quit) {}
