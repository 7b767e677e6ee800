package majic.ros.message;

/** What a base reports that stopped it or endangers it, from whichever message. */
public enum Hazard {
    /** The base refuses to back up any farther. */
    BACKUP_LIMIT("backup limit"),
    /** A bumper is pressed. */
    BUMP("bump"),
    /** A sensor is above a step. */
    CLIFF("cliff"),
    /** The wheels do not turn as commanded. */
    STALL("stall"),
    /** A wheel hangs in the air. */
    WHEEL_DROP("wheel drop"),
    /** Something is near. */
    PROXIMITY("proximity"),
    /** A kind that is not known here. */
    OTHER("hazard");

    private final String words;

    Hazard(String words) {
        this.words = words;
    }

    /**
     * Returns its name for users.
     *
     * @return one or two words
     */
    public String words() {
        return words;
    }
}
