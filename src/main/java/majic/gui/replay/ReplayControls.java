package majic.gui.replay;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.bot.Value;
import majic.gui.kit.Mnemonics;
import majic.recorder.Recording;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Play and pause, the time slider and the speed of a replay. */
final class ReplayControls extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ReplayControls.class);
    private static final List<Double> SPEEDS = List.of(0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0);

    private final JButton play = new PlayButton();
    private final JButton previous = new JButton(TEXTS.get("previous"));
    private final JButton next = new JButton(TEXTS.get("next"));
    private final JLabel time = new JLabel();
    private final JComboBox<String> speed;
    private final transient ReplayPart part;
    private final Timeline timeline;

    /** Goes to other parts of the recording. */
    interface PartTurner {
        /** Opens the file of another part, and plays it if that is wanted. */
        void turnTo(Path file, boolean playing);
    }

    ReplayControls(ReplayPart part, ReplayPlayer player, PartTurner turner) {
        super(new MigLayout("insets 6 10 8 10, gap 0 6, wrap 1", "[grow, fill]"));
        Recording recording = part.recording();
        this.part = part;
        this.timeline = new Timeline(recording.beginS(), recording.endS(), recording.marks(0), player::jump);
        play.setName("play");
        play.setToolTipText(TEXTS.get("play.hint"));
        play.addActionListener(event -> {
            if (player.isPlaying()) {
                player.pause();
            } else {
                player.play();
            }
        });
        time.setName("replayTime");
        prepare(previous, "previousPart", part.adjacent().previous(), turner);
        prepare(next, "nextPart", part.adjacent().next(), turner);
        setTurning(false);
        speed = new JComboBox<>(Stream.of(SPEEDS.toArray(new Double[0]))
                .map(times -> Value.plain(times) + " \u00d7")
                .toArray(String[]::new));
        speed.setName("replaySpeed");
        speed.getAccessibleContext().setAccessibleName(TEXTS.get("speed.name"));
        speed.setSelectedIndex(SPEEDS.indexOf(1.0));
        speed.addActionListener(event -> player.setSpeed(SPEEDS.get(speed.getSelectedIndex())));
        JLabel speedLabel = new JLabel(TEXTS.get("speed"));
        speedLabel.setLabelFor(speed);
        JPanel row = new JPanel(new MigLayout("insets 0, gap 10, hidemode 3"));
        row.add(play);
        row.add(previous);
        row.add(next);
        row.add(time, "pushx, growx");
        row.add(speedLabel);
        row.add(speed);
        add(timeline);
        add(row);
        Mnemonics.assign(this);
    }

    private void prepare(JButton button, String name, Optional<Path> file, PartTurner turner) {
        button.setName(name);
        button.setVisible(part.hasOthers());
        button.addActionListener(event -> file.ifPresent(other -> turner.turnTo(other, false)));
    }

    /** Disables the buttons of other parts while one of them is read, and at the ends of the recording. */
    void setTurning(boolean turning) {
        previous.setEnabled(!turning && part.adjacent().previous().isPresent());
        next.setEnabled(!turning && part.adjacent().next().isPresent());
    }

    /** Chooses one of the speeds that are offered. */
    void setSpeed(double times) {
        speed.setSelectedIndex(SPEEDS.indexOf(times));
    }

    /** The button that has the focus first. */
    JButton playButton() {
        return play;
    }

    /** Shows the position. */
    void show(double seconds, boolean playing) {
        play.setText(TEXTS.get(playing ? "pause" : "play"));
        time.setText(TEXTS.get(
                "position",
                ReplayTimes.clock(seconds),
                ReplayTimes.clock(part.recording().endS()),
                ReplayTimes.timeOfDay(part.recording().head().timeOfDay(seconds))));
        timeline.follow(seconds);
    }

    /**
     * Has room for both of its texts, also in the bold type of a default button, so that it stays the same while
     * playing.
     */
    private static final class PlayButton extends JButton {
        private static final long serialVersionUID = 1L;

        PlayButton() {
            super(TEXTS.get("play"));
        }

        @Override
        public Dimension getPreferredSize() {
            Dimension size = super.getPreferredSize();
            FontMetrics metrics = getFontMetrics(getFont().deriveFont(Font.BOLD));
            int text = Math.max(metrics.stringWidth(TEXTS.get("play")), metrics.stringWidth(TEXTS.get("pause")));
            Insets insets = getInsets();
            return new Dimension(Math.max(size.width, text + insets.left + insets.right), size.height);
        }
    }
}
