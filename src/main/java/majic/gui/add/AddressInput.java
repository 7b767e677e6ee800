package majic.gui.add;

import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;

/** A few fields from which a robot's address is made. */
abstract class AddressInput extends JPanel {
    private static final long serialVersionUID = 1L;

    AddressInput() {
        super(new MigLayout("insets 0, gap 8 8", "[90!, right][grow, fill]", ""));
    }

    /**
     * The address as one would type it.
     *
     * @throws majic.bot.BotException if a field is not filled in properly; the message says which and how
     */
    abstract String address();

    /** What to try when nothing answers there. */
    abstract String advice();
}
