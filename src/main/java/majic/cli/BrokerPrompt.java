package majic.cli;

import java.io.Console;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerLogins;

/** Asks in the terminal for the user name and the password of a broker that refuses those it was given. */
final class BrokerPrompt {
    private static final int ATTEMPTS = 3;

    private BrokerPrompt() {}

    /**
     * Runs what connects with a broker, again with what the user types while the broker refuses it.
     *
     * @param broker the address
     * @param connecting connects
     * @throws ConnectFailed if it cannot be connected, there is no terminal, or the user types nothing
     */
    static void connecting(String broker, Runnable connecting) {
        Console terminal = System.console();
        for (int attempt = 1; ; attempt++) {
            try {
                connecting.run();
                return;
            } catch (ConnectFailed e) {
                if (e.reason() != Reason.WRONG_LOGIN
                        || terminal == null
                        || attempt > ATTEMPTS
                        || !asked(terminal, broker)) {
                    throw e;
                }
            }
        }
    }

    private static boolean asked(Console terminal, String broker) {
        BrokerAddress address = BrokerAddress.parse(broker);
        String user = terminal.readLine("User at the broker %s: ", address.hostAndPort());
        char[] password = user == null || user.isBlank() ? null : terminal.readPassword("Password: ");
        if (password == null) {
            return false;
        }
        BrokerLogins.use(address, user.strip(), new String(password));
        return true;
    }
}
