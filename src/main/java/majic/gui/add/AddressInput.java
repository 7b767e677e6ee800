package majic.gui.add;

import javax.swing.JPanel;
import majic.bot.BotAddress;
import majic.bot.BotException;
import net.miginfocom.swing.MigLayout;

/** Input fields from which a robot's address is made. */
abstract class AddressInput extends JPanel {
    private static final long serialVersionUID = 1L;

    /** The property that changes to a sentence when something in these fields cannot be done; the dialog shows it. */
    static final String PROBLEM = "problem";

    /** Receives that a broker has refused the user name or the password when these fields used it. */
    interface RefusalListener {
        /**
         * Reports the refusal, on the event dispatch thread.
         *
         * @param address an address at the broker
         * @param again repeats what was refused
         */
        void refused(BotException refusal, String address, Runnable again);
    }

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

    /** Sets what receives refusals; fields that connect with nothing have none. */
    void onRefusal(RefusalListener listener) {}

    /** Returns what to try when there is no answer from the address. */
    abstract String advice();
}
