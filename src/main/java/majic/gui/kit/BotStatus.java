package majic.gui.kit;

import majic.bot.BotState;
import majic.bot.Pose;
import majic.team.Member;
import majic.team.Owner;
import majic.text.Texts;

/** Formats the texts of the status strip above a robot's display. */
public final class BotStatus {
    private static final Texts TEXTS = Texts.of(BotStatus.class);

    private BotStatus() {}

    /** Describes how the robot is connected and whether it moves. */
    public static String condition(Member member) {
        return switch (member.bot().connection()) {
            case NEW -> TEXTS.get("new");
            case CONNECTING -> TEXTS.get("connecting");
            case CONNECTED -> TEXTS.get(member.bot().state().moving() ? "moving" : "stationary");
            case LOST -> TEXTS.get("lost");
            case CLOSED -> TEXTS.get("closed");
        };
    }

    /** Names the robot's exclusive owner; empty if there is none. */
    public static String owner(Member member) {
        Owner owner = member.owner();
        if (owner == null) {
            return "";
        }
        return switch (owner.kind()) {
            case MANUAL -> TEXTS.get("byHand");
            case REMOTE -> TEXTS.get("held", owner.name());
            case ACT, SCRIPT -> TEXTS.get("running", owner.title());
        };
    }

    /** Names the robot's exclusive owner, or the user of another program that holds it; empty if there is neither. */
    public static String user(Member member) {
        String owner = owner(member);
        return owner.isEmpty()
                ? member.bot()
                        .remoteHolder()
                        .map(holder -> TEXTS.get("held", holder))
                        .orElse("")
                : owner;
    }

    /** Returns whether an act owns the robot. */
    public static boolean isInAct(Member member) {
        Owner owner = member.owner();
        return owner != null && owner.kind() == Owner.Kind.ACT;
    }

    /** Describes the robot's estimated pose. */
    public static String pose(Member member) {
        BotState state = member.bot().state();
        if (state.equals(BotState.UNKNOWN)) {
            return TEXTS.get("noPosition");
        }
        Pose at = state.pose();
        return TEXTS.get(
                member.bot().profile().estimates() ? "pose.estimated" : "pose",
                Math.round(at.xMm()),
                Math.round(at.yMm()),
                Math.round(at.headingDeg()));
    }
}
