package majic.gui.bots;

import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.panel.RefreshTicks;
import majic.team.Member;

/** Updates what shows a robot of the team at a limited rate, however fast the robot reports. Thread-safe. */
final class MemberRefresh implements BotListener {
    private final MajicBot bot;
    private final Runnable update;

    /**
     * Listens to the robot until {@link #close()}.
     *
     * @param update runs on the event dispatch thread, at most ten times a second, after a change
     */
    MemberRefresh(Member member, Runnable update) {
        this.bot = member.bot();
        this.update = update;
        bot.addListener(this);
    }

    /** Schedules an update. */
    void changed() {
        RefreshTicks.once(update);
    }

    /** Removes the listener. */
    void close() {
        bot.removeListener(this);
    }

    @Override
    public void stateChanged(MajicBot source, BotState state) {
        changed();
    }

    @Override
    public void connectionChanged(MajicBot source, MajicBot.Connection connection) {
        changed();
    }
}
