package majic.shared.desk;

import java.util.Collection;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.shared.broker.BrokerAddress;
import majic.shared.message.RobotMessage.Kind;
import majic.team.Answer;
import majic.team.Member;
import majic.team.StopStatus;
import majic.team.TeamListener;
import org.jspecify.annotations.Nullable;

/** Keeps the shared robots up to date with the team: robots that come and go, their answers, messages and owners. */
final class SharedTeam implements TeamListener {
    private final DeskContext desk;
    private final Set<Integer> chosen;
    private final Map<Integer, SharedRobot> robots;
    private final DeskPresence presence;
    private final @Nullable DeskFleet fleet;

    /**
     * @param chosen the numbers to share; empty for all
     * @param robots is filled and emptied here
     * @param fleet publishes the robots as vehicles, too; null if that is not wanted
     */
    SharedTeam(
            DeskContext desk,
            Set<Integer> chosen,
            Map<Integer, SharedRobot> robots,
            DeskPresence presence,
            @Nullable DeskFleet fleet) {
        this.desk = desk;
        this.chosen = chosen;
        this.robots = robots;
        this.presence = presence;
        this.fleet = fleet;
    }

    void begin() {
        desk.team().addListener(this);
        desk.team().members().forEach(this::added);
        presence.publish();
    }

    /** Removes what the broker keeps of the robots, if the name is still that of this desk. */
    void end() {
        desk.team().removeListener(this);
        robots.values().forEach(this::end);
        robots.clear();
    }

    private void removeVehicle(SharedRobot robot) {
        if (fleet != null) {
            fleet.remove(robot);
        }
    }

    private void end(SharedRobot robot) {
        robot.bot().removeListener(new Reports(robot));
        robot.remove();
        removeVehicle(robot);
        if (presence.isActive()) {
            robot.publisher().end();
        }
    }

    /** A robot that is itself reached through a broker is shared by the desk that has it. */
    private boolean isShared(Member member) {
        return !member.bot().type().isMeantBy(BrokerAddress.SCHEME)
                && (chosen.isEmpty() || chosen.contains(member.number()));
    }

    @Override
    public void added(Member member) {
        if (!isShared(member)) {
            return;
        }
        SharedRobot robot = new SharedRobot(desk, member);
        SharedRobot before = robots.put(member.number(), robot);
        if (before != null) {
            before.bot().removeListener(new Reports(before));
        }
        if (before != null && before.member() != member) {
            before.remove();
            removeVehicle(before);
        }
        if (fleet != null) {
            fleet.add(robot);
        }
        member.bot().addListener(new Reports(robot));
        robot.publisher().changed();
    }

    @Override
    public void removed(Member member) {
        SharedRobot robot = robots.get(member.number());
        if (robot != null && robot.member() == member && robots.remove(member.number(), robot)) {
            end(robot);
            desk.wake().run();
        }
    }

    @Override
    public void answered(Answer answer) {
        with(answer.robot(), robot -> robot.publishLine(Kind.ANSWER, withoutNumber(answer.text(), answer.robot())));
    }

    @Override
    public void noticed(int number, String message) {
        with(number, robot -> robot.publishLine(Kind.MESSAGE, withoutNumber(message, number)));
    }

    private static String withoutNumber(String line, int number) {
        return line.replaceFirst("^" + number + ":? ", "");
    }

    @Override
    public void lost(Member member, String reason) {
        with(member.number(), robot -> {
            robot.linkLost();
            robot.publishLine(Kind.ALARM, "connection lost: " + reason);
        });
    }

    @Override
    public void regained(Member member) {
        with(member.number(), robot -> robot.publisher().repeat());
    }

    @Override
    public void renamed(Member member) {
        with(member.number(), robot -> robot.publisher().repeat());
    }

    @Override
    public void ownerChanged(Member member) {
        with(member.number(), robot -> robot.publisher().changed());
    }

    @Override
    public void stopOverdue(Collection<Member> members, double seconds) {
        members.forEach(member -> with(
                member.number(),
                robot -> robot.publishLine(Kind.ALARM, "the stop is not confirmed after " + seconds + " s")));
    }

    @Override
    public void latchChanged(boolean latched) {
        robots.values().forEach(robot -> robot.publisher().changed());
    }

    @Override
    public void stopStatusChanged(StopStatus status) {
        robots.values().forEach(robot -> robot.publisher().changed());
    }

    private void with(int number, Consumer<SharedRobot> action) {
        SharedRobot robot = robots.get(number);
        if (robot != null) {
            action.accept(robot);
        }
    }

    /**
     * Passes on that a robot has reported something. Equal to the other one of the same robot, so that it can be
     * removed.
     */
    private record Reports(SharedRobot robot) implements BotListener {
        @Override
        public void stateChanged(MajicBot bot, BotState state) {
            robot.publisher().reported(state.moving());
        }

        @Override
        public void connectionChanged(MajicBot bot, MajicBot.Connection connection) {
            robot.publisher().changed();
        }
    }
}
