package majic.gui.kit;

import majic.team.Member;
import majic.team.StopStatus;
import majic.team.TeamListener;

/** Passes events of a team on to a part of the window, on the event dispatch thread. */
public record EventThreadTeamListener(TeamListener target) implements TeamListener {
    @Override
    public void added(Member member) {
        EventThread.later(() -> target.added(member));
    }

    @Override
    public void removed(Member member) {
        EventThread.later(() -> target.removed(member));
    }

    @Override
    public void renamed(Member member) {
        EventThread.later(() -> target.renamed(member));
    }

    @Override
    public void ownerChanged(Member member) {
        EventThread.later(() -> target.ownerChanged(member));
    }

    @Override
    public void latchChanged(boolean latched) {
        EventThread.later(() -> target.latchChanged(latched));
    }

    @Override
    public void stopStatusChanged(StopStatus status) {
        EventThread.later(() -> target.stopStatusChanged(status));
    }
}
