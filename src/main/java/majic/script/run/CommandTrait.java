package majic.script.run;

/** What has to be known of a command before it runs. */
public enum CommandTrait {
    /** Makes its robots do something: a script claims them, and a stop before its turn drops the line. */
    COMMANDS_ROBOTS,
    /** Its check reads files, so it may block and needs the worker of its source. */
    READS_FILES,
    /** Writes a file that a later command of the same script may name; is refused from another computer. */
    WRITES_FILE,
    /** Afterwards other robots may be in the team or have other names, or other code may be agreed to. */
    CHANGES_TEAM,
    /** Afterwards {@code maxMove} may be another one, so only the robot can check how far a move may go. */
    CHANGES_LIMIT,
    /** Is refused from a socket. */
    LOCAL_ONLY
}
