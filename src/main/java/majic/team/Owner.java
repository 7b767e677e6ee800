package majic.team;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.bot.BotException;
import majic.driver.Permit;

/** An exclusive owner of a robot: a script, an act, manual control, or a user at another desk. Compared by identity. */
public final class Owner {
    /** What kinds of owners there are. */
    public enum Kind {
        /** A running script. */
        SCRIPT,
        /** A running act. */
        ACT,
        /** A user in manual control. */
        MANUAL,
        /** A user at another desk, through a broker. */
        REMOTE
    }

    private static final Logger LOG = System.getLogger(Owner.class.getName());

    private final Kind kind;
    private final String name;
    private final String title;
    private final Permit permit;
    private final Runnable end;
    private volatile String status = "";

    /**
     * Describes an owner.
     *
     * @param kind the kind of owner
     * @param name the name in messages
     * @param end ends the owner; called on a thread of its own when another source stops one of its robots
     */
    public Owner(Kind kind, String name, Runnable end) {
        this(kind, name, name, end);
    }

    /**
     * Describes an owner that was begun with values of its own.
     *
     * @param title the name with these values
     */
    public Owner(Kind kind, String name, String title, Runnable end) {
        this(kind, name, title, new Permit(), end);
    }

    /**
     * Describes an owner with a permit that it has already.
     *
     * @param permit the permission to move its robots; a stop of one of them revokes it
     */
    public Owner(Kind kind, String name, String title, Permit permit, Runnable end) {
        this.kind = kind;
        this.name = name;
        this.title = title;
        this.permit = permit;
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
     * Returns the name with the values that the owner was begun with.
     *
     * @return for instance {@code WanderDog turn=90deg}; the name alone without values
     */
    public String title() {
        return title;
    }

    /**
     * Returns the latest status message of this owner.
     *
     * @return the message; empty until there is one
     */
    public String status() {
        return status;
    }

    void status(String words) {
        status = words;
    }

    /** Ends this owner, without stopping any robot: the owner does that, or it was done. */
    public void end() {
        end.run();
    }

    /** Does as {@link #end}; errors are logged. */
    void endLoggingErrors() {
        try {
            end();
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, name + " failed to end", e);
        }
    }

    /**
     * Returns the permission of this owner to move its robots. Once it is revoked, all further commands of this owner
     * that move a robot are rejected, even those sent before it ends.
     *
     * @return the permit, which a stop of one of its robots by another source revokes
     */
    public Permit permit() {
        return permit;
    }

    /**
     * Returns whether this owner's permission to move its robots was revoked, by a stop or because it ends.
     *
     * @return true from the moment of the stop, before its {@code end} is called
     */
    public boolean isRevoked() {
        return permit.isRevoked();
    }

    /**
     * Returns what a robot does for this owner.
     *
     * @return {@code running WanderDog}, {@code driven by hand} or {@code held by Anna at desk1}
     */
    public String occupation() {
        return occupation(name);
    }

    /**
     * Returns what a robot does for this owner, with the values that the owner was begun with.
     *
     * @return as {@link #occupation()}, with {@link #title()} in place of the name
     */
    public String occupationWithValues() {
        return occupation(title);
    }

    private String occupation(String shown) {
        return switch (kind) {
            case SCRIPT, ACT -> "running " + shown;
            case MANUAL -> "driven by hand";
            case REMOTE -> "held by " + shown;
        };
    }

    /** Returns what refuses another source's command to a robot of this owner. */
    BotException refusal(int robot) {
        return new BotException(robot + " is " + occupation() + "; \"" + robot + " stop\" ends it");
    }
}
