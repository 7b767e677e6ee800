package majic.aibo.panel;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.JComponent;
import majic.aibo.body.Calibration;
import majic.aibo.body.DogState;
import majic.aibo.urbi.UrbiValue;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.environment.Settings;
import majic.text.Texts;

/** The panel of a recorded dog. */
public final class AiboReplay implements ReplayDisplay {
    private static final Texts TEXTS = Texts.of(AiboReplay.class);
    private static final long NANOS_PER_MS = 1_000_000;

    private final MajicBot bot;
    private final DogState dog = new DogState(new Calibration(Settings.inMemory(), "recorded"));
    private final JComponent panel;
    private PanelPoller.PictureReceiver pictures;

    /** Creates the panel of a dog that is replayed. */
    public AiboReplay(MajicBot bot) {
        this.bot = bot;
        this.panel = AiboPanel.create(bot, dog, this::receive);
    }

    /** Pictures come as they were recorded, whether they are visible or not. */
    private Consumer<Boolean> receive(PanelPoller.PictureReceiver receiver) {
        pictures = receiver;
        return visible -> {};
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public void reset() {
        dog.forgetReadings();
        pictures.miss(TEXTS.get("camera.notRecorded"));
    }

    @Override
    public void show(Map<String, String> state, long nanos) {
        dog.restore(state, bot.state().pose(), nanos / NANOS_PER_MS);
    }

    @Override
    public void showPicture(byte[] jpeg) {
        pictures.see(new UrbiValue.Binary(List.of("jpeg"), jpeg), 0);
    }
}
