package majic.script.run;

import majic.script.conditions.Selection;

/**
 * What a command for the session is checked against.
 *
 * @param selection finds the robots it names
 * @param filesMayAppear whether an earlier command of the same script writes files
 */
public record SessionCheck(Selection selection, boolean filesMayAppear) {}
