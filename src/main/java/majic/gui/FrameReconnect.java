package majic.gui;

import java.util.Optional;
import java.util.function.Consumer;
import majic.environment.Settings;
import majic.gui.kit.BackgroundSettings;
import majic.gui.kit.EventThread;
import majic.team.AutoReconnect;
import majic.team.Member;
import majic.team.Team;

/** Reconnects lost robots while the window is open, unless the user has switched that off, which is kept. */
final class FrameReconnect implements AutoCloseable {
    private static final String KEY = "robots.reconnect";
    private static final String OFF = "off";

    private final AutoReconnect attempts;
    private final Settings settings;

    /**
     * Begins to watch for lost robots.
     *
     * @param changed receives a robot whose attempts have changed, on the event dispatch thread
     */
    FrameReconnect(Team team, Settings settings, Consumer<Member> changed) {
        this.settings = settings;
        attempts = new AutoReconnect(team, member -> EventThread.later(() -> changed.accept(member)));
        attempts.enable(!settings.get(KEY).equals(Optional.of(OFF)));
    }

    AutoReconnect attempts() {
        return attempts;
    }

    boolean isEnabled() {
        return attempts.isEnabled();
    }

    /** Switches the attempts on or off, and keeps the choice, in the background. */
    void enable(boolean on) {
        EventThread.background("switching reconnecting", () -> attempts.enable(on));
        BackgroundSettings.put(settings, KEY, on ? "on" : OFF);
    }

    @Override
    public void close() {
        attempts.close();
    }
}
