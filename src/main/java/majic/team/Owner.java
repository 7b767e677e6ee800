package majic.team;

import majic.bot.BotException;

/**
 * Somebody who has a robot to himself: a script, an act, a hand on the keys. Compared by identity.
 */
public final class Owner {
    /** What kinds of owners there are. */
    public enum Kind {
        /** A running script. */
        SCRIPT,
        /** A running act. */
        ACT,
        /** A person driving by hand. */
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
     * @param kind what it is
     * @param name what messages call it
     * @param end ends it; called on a thread of its own when somebody else stops a robot of its
     */
    public Owner(Kind kind, String name, Runnable end) {
        this.kind = kind;
        this.name = name;
        this.end = end;
    }

    /**
     * What it is.
     *
     * @return its kind
     */
    public Kind kind() {
        return kind;
    }

    /**
     * What messages call it.
     *
     * @return for instance {@code WanderDog}
     */
    public String name() {
        return name;
    }

    /**
     * What it said last of its doings.
     *
     * @return its words; empty until it says something
     */
    public String said() {
        return said;
    }

    void said(String words) {
        said = words;
    }

    /**
     * Ends it, without stopping any robot: that is for it to do, or was done.
     */
    public void end() {
        end.run();
    }

    /** As {@link #end}; what it throws is logged. */
    void endWhateverHappens() {
        try {
            end();
        } catch (RuntimeException | Error e) {
            Team.LOG.log(System.Logger.Level.ERROR, name + " did not end well", e);
        }
    }

    /** Takes no further order of his that moves a robot, however late he hears of his end. */
    void dismiss() {
        dismissed = true;
    }

    /**
     * Whether a stop took from it the permission to move its robots.
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
