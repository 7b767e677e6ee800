package majic.panel;

import java.awt.Color;
import java.awt.Font;
import java.awt.Insets;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import javax.swing.text.View;

/**
 * Shows a sentence across the top of a panel, as high as its text needs; hidden when there is none. An alarm is in bold
 * and in reversed colours. Must be used on the event dispatch thread.
 */
public final class Banner extends JTextArea {
    private static final long serialVersionUID = 1;
    private static final int PAD = 6;
    private static final float ALARM_SIZE = 1.1f;

    private boolean alarm;

    /** Creates a banner without text. */
    public Banner() {
        setName("banner");
        setEditable(false);
        setFocusable(false);
        setLineWrap(true);
        setWrapStyleWord(true);
        setVisible(false);
        dress();
    }

    /**
     * Shows a message about what the user should know or do.
     *
     * @param words whole sentences, short; empty to hide the banner
     * @param urgent whether it must be acted on at once
     */
    public void show(String words, boolean urgent) {
        if (words.equals(getText()) && urgent == alarm) {
            return;
        }
        alarm = urgent;
        setText(words);
        dress();
        setVisible(!words.isEmpty());
        getAccessibleContext().setAccessibleName(words);
        revalidate();
    }

    /** Returns the height that its text needs. */
    int heightIn(int width) {
        Insets insets = getInsets();
        View words = getUI().getRootView(this);
        words.setSize(Math.max(1, width - insets.left - insets.right), Short.MAX_VALUE);
        return (int) Math.ceil(words.getPreferredSpan(View.Y_AXIS)) + insets.top + insets.bottom;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        dress();
    }

    private void dress() {
        DrawingColors colors = DrawingColors.current();
        Font font = UIManager.getFont("Label.font");
        if (font != null) {
            setFont(alarm ? font.deriveFont(Font.BOLD, font.getSize2D() * ALARM_SIZE) : font.deriveFont(Font.PLAIN));
        }
        Color edge = alarm ? colors.alarm() : colors.grey(0.5);
        setOpaque(true);
        setBackground(alarm ? colors.alarm() : colors.grey(0.08));
        setForeground(alarm ? colors.paper() : colors.line());
        setBorder(BorderFactory.createCompoundBorder(
                BorderFactory.createLineBorder(edge), BorderFactory.createEmptyBorder(PAD / 2, PAD, PAD / 2, PAD)));
    }
}
