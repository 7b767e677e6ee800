package majic.gui.replay;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.gui.kit.LineArt;
import majic.text.ErrorWords;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** The striped band above a replay, so that it cannot be mistaken for the robots. */
final class ReplayBand extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ReplayBand.class);
    private static final int STRIPE_PX = 14;
    private static final int STRIPES_WIDTH_PX = 56;

    /** Pixels by which text may be wider on a screen of another scale than measured. */
    private static final int TEXT_RESERVE = 8;

    private final JLabel note = new JLabel(TEXTS.get("noRobot"));

    /**
     * Creates the band.
     *
     * @param what the recording
     * @param stop stops all robots
     */
    ReplayBand(String what, JComponent stop) {
        super(new MigLayout("insets 7 70 7 70, fillx", "[grow, fill][][]"));
        JLabel title = new JLabel(TEXTS.get("replayOf", what));
        title.setName("replayBand");
        title.putClientProperty("FlatLaf.styleClass", "h4");
        title.setForeground(ink());
        note.setName("replayNote");
        note.setToolTipText(note.getText());
        note.setForeground(ink());
        note.setBorder(BorderFactory.createEmptyBorder(0, 0, 0, TEXT_RESERVE));
        add(title, "wmin pref");
        add(note, "wmin 0");
        add(stop, "growy, wmin pref");
    }

    /** Shows why another part cannot be shown, in place of the note. */
    void showProblem(String reason) {
        note.setText(ErrorWords.of(reason));
        note.setToolTipText(note.getText());
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setBackground(paper());
        for (Component part : getComponents()) {
            if (part instanceof JLabel) {
                part.setForeground(ink());
            }
        }
    }

    private static Color paper() {
        return FlatLaf.isLafDark() ? new Color(0x4A3B00) : new Color(0xFFE9A8);
    }

    private static Color ink() {
        return FlatLaf.isLafDark() ? new Color(0xFFE08A) : new Color(0x3D3000);
    }

    private static Color stripe() {
        return FlatLaf.isLafDark() ? new Color(0x8A6D00) : new Color(0xE0B000);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        Graphics2D pen = (Graphics2D) graphics.create();
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        pen.setColor(stripe());
        paintStripes(pen, 0);
        paintStripes(pen, getWidth() - UIScale.scale(STRIPES_WIDTH_PX));
        pen.dispose();
    }

    private void paintStripes(Graphics2D pen, int left) {
        int width = UIScale.scale(STRIPES_WIDTH_PX);
        int stripeWidth = UIScale.scale(STRIPE_PX);
        Graphics2D part = (Graphics2D) pen.create(left, 0, width, getHeight());
        for (int x = -getHeight(); x < width; x += 2 * stripeWidth) {
            int top = x + getHeight();
            part.fill(new LineArt()
                    .area(x, getHeight(), top, 0, top + stripeWidth, 0, x + stripeWidth, getHeight())
                    .shape());
        }
        part.dispose();
    }
}
