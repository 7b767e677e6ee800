package majic.script.run;

import majic.log.SessionOutput;
import majic.script.record.SessionRecord;
import majic.team.Team;

/**
 * What all lines of a session share.
 *
 * @param team the robots
 * @param output where answers go
 * @param record what was done so far
 */
public record SessionState(Team team, SessionOutput output, SessionRecord record) {}
