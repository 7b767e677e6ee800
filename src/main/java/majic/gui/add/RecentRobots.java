package majic.gui.add;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.environment.Settings;

/** The addresses of the robots that were connected last, kept in the settings. Robots of the lab are not kept. */
public final class RecentRobots {
    private static final String KEY = "robots.recent";
    private static final int MOST = 12;

    private final Settings settings;

    public RecentRobots(Settings settings) {
        this.settings = settings;
    }

    /** Returns the addresses, the newest first. */
    List<String> all() {
        return settings.get(KEY)
                .map(text ->
                        text.lines().filter(line -> line.matches("[^:]+:.+")).toList())
                .orElse(List.of());
    }

    /**
     * Keeps addresses as the newest ones. May block.
     *
     * @param addresses as they are typed, the newest last
     * @throws BotException if they cannot be kept for the next start
     */
    public void keep(List<String> addresses) {
        List<String> recent = new ArrayList<>(all());
        addresses.stream()
                .filter(address -> !BotAddress.parse(address).scheme().equals(BotAddress.SIMULATED))
                .forEach(address -> {
                    recent.removeIf(address::equalsIgnoreCase);
                    recent.add(0, address);
                });
        String text = String.join("\n", recent.subList(0, Math.min(MOST, recent.size())));
        if (!text.isEmpty() && !settings.get(KEY).equals(Optional.of(text))) {
            settings.put(KEY, text);
        }
    }
}
