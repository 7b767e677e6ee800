package majic.gui.add;

import javax.swing.JPanel;
import majic.bot.BotAddress;
import net.miginfocom.swing.MigLayout;

/** Input fields from which a robot's address is made. */
abstract class AddressInput extends JPanel {
    private static final long serialVersionUID = 1L;

    /** The property that changes to a sentence when something in these fields cannot be done; the dialog shows it. */
    static final String PROBLEM = "problem";

    AddressInput() {
        super(new MigLayout("insets 0, gap 8 8", "[90!, right][grow, fill]", ""));
    }

    /**
     * Returns the address in the form in which it is typed in a command.
     *
     * @throws majic.bot.BotException if a field is not filled in properly; the message says which and how
     */
    abstract String address();

    /**
     * Fills in the fields for an address.
     *
     * @return false if it is an address for other fields; nothing is changed then
     */
    abstract boolean fill(BotAddress address);

    /** Returns what to try when there is no answer from the address. */
    abstract String advice();
}
