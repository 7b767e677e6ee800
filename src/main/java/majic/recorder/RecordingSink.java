package majic.recorder;

import majic.bot.Parameter;

/** Receives the content of a recording line by line, in order. Methods that are not overridden ignore their lines. */
interface RecordingSink {
    /** Every line begins with its time; called before the method for the line. */
    default void time(double seconds) {}

    /** A wall, a tape or a lamp of the room; the numbers are millimetres. */
    default void room(RecordingFormat.Kind kind, double[] places) {}

    /** A robot joins the recording. */
    default void robot(RecordedRobot robot) {}

    /** A parameter of which values follow; {@code about} is whether they are estimates. */
    default void parameter(int robot, Parameter parameter, boolean about) {}

    /** A change of something that a robot has: one of {@code VALUE}, {@code STATUS}, {@code REPORT}, {@code TRUTH}. */
    default void change(RecordingFormat.Kind kind, int robot, String name, String text) {}

    /** A laser scanner of which scans follow, for {@link ScanText#sensor(String[])}. */
    default void sensor(int robot, String[] columns) {}

    /**
     * What a laser scanner has measured, for {@link ScanText#scan(String[], majic.bot.RangeSensor)}; 4 columns or more.
     */
    default void scan(int robot, String[] columns) {}

    /** A picture of a robot's camera, as the text of its bytes in base 64. */
    default void picture(int robot, String jpeg) {}

    /** Something that has happened to a robot or to the team. */
    default void event(Mark mark) {}

    /** A line of the session. */
    default void line(RecordedLine line) {}
}
