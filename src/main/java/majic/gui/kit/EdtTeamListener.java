package majic.gui.kit;

import majic.team.Member;
import majic.team.StopStatus;
import majic.team.TeamListener;

/** Passes events of a team on to a part of the window, on the event dispatch thread. */
public record EdtTeamListener(TeamListener target) implements TeamListener {
    @Override
    public void added(Member member) {
        Edt.later(() -> target.added(member));
    }

    @Override
    public void removed(Member member) {
        Edt.later(() -> target.removed(member));
    }

    @Override
    public void ownerChanged(Member member) {
        Edt.later(() -> target.ownerChanged(member));
    }

    @Override
    public void latchChanged(boolean latched) {
        Edt.later(() -> target.latchChanged(latched));
    }

    @Override
    public void stopStatusChanged(StopStatus status) {
        Edt.later(() -> target.stopStatusChanged(status));
    }
}
