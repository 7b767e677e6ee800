package majic.gui.acts;

import java.awt.Window;
import majic.act.file.ActFile;
import majic.bot.BotException;
import majic.bot.Settings;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.EventThread;
import majic.script.ActOffer;
import majic.script.ActOffers;
import majic.script.Session;

/**
 * Guides through loading an act onto one or several robots: choice of the act, consent to its code, further robots, and finally the
 * command that loads it. Until that command nothing is changed, and none of the act's code is loaded.
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
        new ChooseActDialog(owner, session.offers(), settings, targets, offer -> askConsent(targets, offer))
                .setVisible(true);
    }

    private void askConsent(LoadTargets targets, ActOffer offer) {
        ActOffers offers = session.offers();
        ActFile file = offer.file();
        if (file == null || !offers.needsConsent(offer)) {
            askRoles(targets, offer);
            return;
        }
        new TrustDialog(owner, file, () -> agree(targets, offer)).setVisible(true);
    }

    /** Stores the consent, which may block; if it cannot be stored, it is valid until the program ends. */
    private void agree(LoadTargets targets, ActOffer offer) {
        EventThread.background(
                "agreement-" + offer.called(),
                () -> {
                    try {
                        session.offers().agree(offer);
                    } catch (BotException e) {
                        channel.showError(String.valueOf(e.getMessage()));
                    }
                    EventThread.later(() -> askRoles(targets, offer));
                },
                channel::showError);
    }

    private void askRoles(LoadTargets targets, ActOffer offer) {
        if (offer.roles().size() == 1) {
            channel.submit(targets.lines(offer));
            return;
        }
        LoadTarget target = targets.first();
        new RolesDialog(
                        owner,
                        offer,
                        target,
                        session.team().members(),
                        others -> channel.submit(target.lines(offer, others)))
                .setVisible(true);
    }
}
