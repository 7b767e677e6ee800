package majic.gui.bots;

import java.awt.BorderLayout;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.SwingConstants;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.gui.drive.DrivePad;
import majic.gui.kit.Pacer;
import majic.gui.kit.Voice;
import majic.team.Member;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/** What stands on a robot's tab: its strip, the display its class brings, and the pad to drive it by hand. */
final class BotPanel extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Logger LOG = System.getLogger(BotPanel.class.getName());

    private final transient Member member;
    private final StatusStrip strip;
    private final transient Pacer pacer;
    private final transient BotListener news = new News();

    /**
     * A panel for a robot; it listens until {@link #close()}.
     *
     * @param changed told, at most ten times a second, that the robot has news
     * @param voice how robots and people are spoken to
     */
    BotPanel(Team team, Member member, Runnable changed, Voice voice) {
        super(new BorderLayout());
        this.member = member;
        setName("bot" + member.number());
        strip = new StatusStrip(member, () -> team.stop(List.of(member), null), voice);
        pacer = new Pacer(() -> {
            strip.update();
            changed.run();
        });
        add(strip, BorderLayout.NORTH);
        add(display(), BorderLayout.CENTER);
        add(new DrivePad(member, voice::complain), BorderLayout.SOUTH);
        member.bot().addListener(news);
    }

    Member member() {
        return member;
    }

    /** Has the strip brought up to date soon; callable from any thread. */
    void news() {
        pacer.news();
    }

    /** Ends listening. */
    void close() {
        member.bot().removeListener(news);
    }

    private JComponent display() {
        JComponent display = ownDisplay();
        if (display == null) {
            JLabel none = new JLabel("no display available", SwingConstants.CENTER);
            none.setName("noDisplay");
            none.setEnabled(false);
            return none;
        }
        JScrollPane scroll = new JScrollPane(new DisplayView(display));
        scroll.setBorder(BorderFactory.createEmptyBorder());
        return scroll;
    }

    /** A robot's class may come from anybody: if its display cannot be made, the robot still has a tab. */
    private @Nullable JComponent ownDisplay() {
        try {
            return member.bot().display();
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "the display of robot " + member.number() + " could not be made", e);
            return null;
        }
    }

    /** Robots talk faster than eyes read: whatever they say, the strip follows at its own pace. */
    private final class News implements BotListener {
        @Override
        public void stateChanged(MajicBot bot, BotState state) {
            pacer.news();
        }

        @Override
        public void connectionChanged(MajicBot bot, MajicBot.Connection connection) {
            pacer.news();
        }
    }
}
