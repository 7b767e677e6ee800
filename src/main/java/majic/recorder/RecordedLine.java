package majic.recorder;

import majic.log.Line;

/**
 * A recorded line of the session. Immutable.
 *
 * @param seconds since the beginning of the recording
 * @param kind what line it is
 * @param text as it was shown
 */
public record RecordedLine(double seconds, Line.Kind kind, String text) {}
