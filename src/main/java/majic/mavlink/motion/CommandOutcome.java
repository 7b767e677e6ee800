package majic.mavlink.motion;

/** What became of a command to the autopilot that the guard of its motion may have ended. */
public enum CommandOutcome {
    /** The heartbeats show its effect. */
    DONE,
    /** It was not sent: the condition held already. */
    NOT_SENT,
    /** It was sent, and the condition became true before its effect was shown. */
    UNCONFIRMED;

    /**
     * Returns the answer for users.
     *
     * @param done the state that the command is for: "armed"
     */
    public String answer(String done) {
        return switch (this) {
            case DONE -> done;
            case NOT_SENT -> "not " + done + ": the condition holds already";
            case UNCONFIRMED -> "not confirmed to be " + done + ": the condition became true before";
        };
    }
}
