package majic.mavlink.panel;

import java.util.Map;
import java.util.Optional;
import javax.swing.JComponent;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import org.jspecify.annotations.Nullable;

/** The panel of a recorded vehicle, and the texts that it is recorded as. */
public final class MavlinkReplay implements ReplayDisplay {
    private final MavlinkPanel panel;
    private String echoes = "";
    private long echoNanos;
    private volatile @Nullable VehicleScene scene;

    /** Creates the panel of a vehicle that is replayed. */
    public MavlinkReplay(MajicBot bot) {
        this.panel = MavlinkPanel.of(bot, () -> Optional.ofNullable(scene));
    }

    /**
     * Returns what is recorded of a scene beside the parameters.
     *
     * @return texts by their names, without line ends
     */
    public static Map<String, String> texts(VehicleScene scene) {
        return VehicleSceneText.of(scene);
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public void reset() {
        scene = null;
        echoes = "";
    }

    @Override
    public void show(Map<String, String> state, long nanos) {
        String newest = VehicleSceneText.echoesOf(state);
        if (!newest.equals(echoes)) {
            echoes = newest;
            echoNanos = nanos;
        }
        VehicleSceneText.parse(state, echoNanos).ifPresent(parsed -> scene = parsed);
    }
}
