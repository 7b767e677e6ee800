package majic.team;

import majic.bot.BotException;

/**
 * An exclusive owner of a robot: a script, an act, or manual control. Compared by identity.
 */
public final class Owner {
    /** What kinds of owners there are. */
    public enum Kind {
        /** A running script. */
        SCRIPT,
        /** A running act. */
        ACT,
        /** A person in manual control. */
        HAND
    }

    private final Kind kind;
    private final String name;
    private final Runnable end;
    private volatile String said = "";
    private volatile boolean dismissed;

    /**
     * Describes an owner.
     *
     * @param kind the kind of owner
     * @param name the name in messages
     * @param end ends the owner; called on a thread of its own when another source stops one of its robots
     */
    public Owner(Kind kind, String name, Runnable end) {
        this.kind = kind;
        this.name = name;
        this.end = end;
    }

    /**
     * Returns the kind of this owner.
     *
     * @return its kind
     */
    public Kind kind() {
        return kind;
    }

    /**
     * Returns the name in messages.
     *
     * @return for instance {@code WanderDog}
     */
    public String name() {
        return name;
    }

    /**
     * Returns the latest status message of this owner.
     *
     * @return the message; empty until there is one
     */
    public String said() {
        return said;
    }

    void said(String words) {
        said = words;
    }

    /**
     * Ends this owner, without stopping any robot: the owner does that, or it was done.
     */
    public void end() {
        end.run();
    }

    /** As {@link #end}; exceptions are logged. */
    void endWhateverHappens() {
        try {
            end();
        } catch (RuntimeException | Error e) {
            Team.LOG.log(System.Logger.Level.ERROR, name + " did not end well", e);
        }
    }

    /** Rejects all further commands of this owner that move a robot, even those sent before it ends. */
    void dismiss() {
        dismissed = true;
    }

    /**
     * Returns whether a stop revoked this owner's permission to move its robots.
     *
     * @return true from the moment of the stop, before its {@code end} is called
     */
    public boolean isDismissed() {
        return dismissed;
    }

    BotException inTheWay(int robot) {
        String what = kind == Kind.HAND ? " is driven by hand" : " is running " + name;
        return new BotException(robot + what + "; \"" + robot + " stop\" ends it");
    }
}
