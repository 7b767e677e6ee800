package majic.recorder;

import java.util.Collection;
import java.util.function.Consumer;
import majic.team.Answer;
import majic.team.CommandListener;
import majic.team.Member;
import majic.team.Team;
import majic.team.TeamListener;

/** Turns what happens in a team into lines of a recording. */
final class EventLines implements TeamListener, CommandListener {
    private final Team team;
    private final Consumer<String> lines;

    /** @param lines receives each line, on the thread of the event */
    EventLines(Team team, Consumer<String> lines) {
        this.team = team;
        this.lines = lines;
    }

    private void event(int robot, Mark.Kind kind, String text) {
        lines.accept(RecordingFormat.event(robot, kind, text));
    }

    @Override
    public void added(Member member) {
        event(member.number(), Mark.Kind.ADDED, member.bot().type().label());
    }

    @Override
    public void removed(Member member) {
        event(member.number(), Mark.Kind.REMOVED, member.bot().type().label());
    }

    @Override
    public void begun(int robot, String command) {
        event(robot, Mark.Kind.BEGUN, robot + " " + command);
    }

    @Override
    public void answered(Answer answer) {
        event(answer.robot(), Mark.Kind.ENDED, answer.text());
    }

    @Override
    public void lost(Member member, String reason) {
        event(member.number(), Mark.Kind.LOST, reason);
    }

    @Override
    public void regained(Member member) {
        event(member.number(), Mark.Kind.REGAINED, "connected again");
    }

    @Override
    public void ownerChanged(Member member) {
        event(member.number(), Mark.Kind.OWNER, RobotSampler.owner(member.owner()));
    }

    @Override
    public void stopped(Collection<Member> members, long atNanos) {
        if (members.size() == team.members().size()) {
            event(0, Mark.Kind.STOP, "all robots");
        } else {
            members.forEach(member -> event(member.number(), Mark.Kind.STOP, "robot " + member.number()));
        }
    }

    @Override
    public void latchChanged(boolean latched) {
        if (!latched) {
            event(0, Mark.Kind.RELEASED, "motion is allowed again");
        }
    }
}
