package majic.gui.acts;

import java.awt.Window;
import java.nio.file.Path;
import majic.act.file.ActFile;
import majic.bot.BotException;
import majic.environment.Settings;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.EventThread;
import majic.script.ActOffers;
import majic.script.Session;

/**
 * Guides through loading an act onto one or several robots: choice of the act, consent to its code, further robots, and
 * finally the command that loads it. Until that command nothing is changed, and none of the act's code is loaded.
 */
public final class ActLoader {
    private final Window owner;
    private final Session session;
    private final CommandChannel channel;
    private final Settings settings;

    public ActLoader(Window owner, Session session, CommandChannel channel, Settings settings) {
        this.owner = owner;
        this.session = session;
        this.channel = channel;
        this.settings = settings;
    }

    /** Starts with the choice of the act. */
    public void load(LoadTargets targets) {
        choice(targets).open();
    }

    /** Starts with the choice of the act, in which the act of a file is selected. */
    public void load(LoadTargets targets, Path file) {
        choice(targets).open(file);
    }

    private ChooseActDialog choice(LoadTargets targets) {
        return new ChooseActDialog(owner, session.offers(), settings, targets, act -> askConsent(targets, act));
    }

    private void askConsent(LoadTargets targets, ChosenAct act) {
        ActOffers offers = session.offers();
        ActFile file = act.offer().file();
        if (file == null || !offers.needsConsent(act.offer())) {
            askRoles(targets, act);
            return;
        }
        new TrustDialog(owner, file, () -> agree(targets, act)).setVisible(true);
    }

    /** Stores the consent, which may block; if it cannot be stored, it is valid until the program ends. */
    private void agree(LoadTargets targets, ChosenAct act) {
        EventThread.background(
                "agreement-" + act.offer().called(),
                () -> {
                    try {
                        session.offers().agree(act.offer());
                    } catch (BotException e) {
                        channel.showError(String.valueOf(e.getMessage()));
                    }
                    EventThread.later(() -> askRoles(targets, act));
                },
                channel::showError);
    }

    private void askRoles(LoadTargets targets, ChosenAct act) {
        if (act.offer().roles().size() == 1) {
            channel.submit(targets.lines(act));
            return;
        }
        LoadTarget target = targets.first();
        new RolesDialog(
                        owner,
                        act.offer(),
                        target,
                        session.team().members(),
                        others -> channel.submit(target.lines(act, others)))
                .setVisible(true);
    }
}
