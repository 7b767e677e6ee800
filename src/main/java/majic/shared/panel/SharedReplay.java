package majic.shared.panel;

import java.util.Map;
import java.util.TreeMap;
import javax.swing.JComponent;
import majic.bot.BotException;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.text.Texts;

/** The panel of a recorded shared robot, and the texts that it is recorded as. */
public final class SharedReplay implements ReplayDisplay {
    private static final Texts TEXTS = Texts.of(SharedReplay.class);
    private static final String YES = "yes";
    private static final SharedScene NONE = new SharedScene("", "", false, "", false);

    private final SharedPanel panel;
    private volatile SharedScene scene = NONE;

    /** Creates the panel of a robot that is replayed. */
    public SharedReplay(MajicBot bot) {
        this.panel = SharedPanel.of(bot, () -> scene, () -> {
            throw new BotException(TEXTS.get("camera.notRecorded"));
        });
    }

    /**
     * Returns what is recorded of a scene beside the parameters.
     *
     * @return texts by their names, without line ends
     */
    public static Map<String, String> texts(SharedScene scene) {
        Map<String, String> texts = new TreeMap<>();
        texts.put("address", scene.address());
        texts.put("holder", scene.holder());
        texts.put("heldHere", scene.heldHere() ? YES : "");
        texts.put("delay", scene.delay());
        texts.put("camera", scene.camera() ? YES : "");
        return texts;
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public void reset() {
        scene = NONE;
        panel.missPicture();
    }

    @Override
    public void show(Map<String, String> state, long nanos) {
        scene = new SharedScene(
                state.getOrDefault("address", ""),
                state.getOrDefault("holder", ""),
                YES.equals(state.get("heldHere")),
                state.getOrDefault("delay", ""),
                YES.equals(state.get("camera")));
    }

    @Override
    public void showPicture(byte[] jpeg) {
        panel.showPicture(jpeg);
    }
}
