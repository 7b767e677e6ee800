package majic.gui.kit;

import majic.bot.BotState;
import majic.bot.Pose;
import majic.team.Member;
import majic.team.Owner;

/** Formats the texts of the status strip above a robot's display. */
public final class BotStatus {
    private BotStatus() {}

    /** Describes how the robot is connected and whether it moves. */
    public static String condition(Member member) {
        return switch (member.bot().connection()) {
            case NEW -> "not connected";
            case CONNECTING -> "connecting…";
            case CONNECTED -> member.bot().state().moving() ? "connected, moving" : "connected, stationary";
            case LOST -> "connection lost";
            case CLOSED -> "closed";
        };
    }

    /** Names the robot's exclusive owner; empty if there is none. */
    public static String owner(Member member) {
        Owner owner = member.owner();
        if (owner == null) {
            return "";
        }
        return switch (owner.kind()) {
            case MANUAL -> "driven by hand";
            case ACT, SCRIPT -> "running " + owner.name();
        };
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
            return "no position yet";
        }
        Pose at = state.pose();
        String about = member.bot().profile().estimates() ? "about " : "";
        return about + "x " + Math.round(at.xMm()) + " mm   y " + Math.round(at.yMm()) + " mm   heading "
                + Math.round(at.headingDeg()) + "°";
    }
}
