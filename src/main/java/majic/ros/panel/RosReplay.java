package majic.ros.panel;

import java.util.Map;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import org.jspecify.annotations.Nullable;

/** The panel of a recorded ROS robot, and the texts that it is recorded as. */
public final class RosReplay implements ReplayDisplay {
    private final MajicBot bot;
    private final RosPanel panel;
    private String scan = "";
    private long scanNanos;
    private volatile @Nullable RosScene scene;

    /** Creates the panel of a robot that is replayed. */
    public RosReplay(MajicBot bot) {
        this.bot = bot;
        this.panel = RosPanel.of(bot, () -> Optional.ofNullable(scene), watched -> {});
    }

    /**
     * Returns what is recorded of a scene beside the parameters.
     *
     * @return texts by their names, without line ends
     */
    public static Map<String, String> texts(RosScene scene) {
        return SceneText.of(scene);
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public void reset() {
        scene = null;
        scan = "";
        SwingUtilities.invokeLater(panel::missPicture);
    }

    @Override
    public void show(Map<String, String> state, long nanos) {
        String newest = SceneText.scanOf(state);
        if (!newest.equals(scan)) {
            scan = newest;
            scanNanos = nanos;
        }
        SceneText.parse(state, bot.connection(), scanNanos).ifPresent(parsed -> scene = parsed);
    }

    @Override
    public void showPicture(byte[] jpeg) {
        panel.showPicture(jpeg);
    }
}
