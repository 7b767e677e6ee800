package majic.gui.start;

import java.awt.Font;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.SwingConstants;
import majic.gui.kit.Icons;
import majic.gui.kit.Palette;
import majic.gui.kit.StyledLabel;
import net.miginfocom.swing.MigLayout;

/** A large button of the start page: picture, title and one line of explanation. */
final class StartButton extends JButton {
    private static final long serialVersionUID = 1L;
    private static final int ICON = 26;

    private final String title;
    private final transient Icon picture;
    private final JLabel detail;
    private final JLabel heading;

    /**
     * Creates a button.
     *
     * @param icon name of one of MAJIC's icons, without {@code .svg}
     */
    StartButton(String title, String detail, String icon, Runnable action) {
        super.setLayout(new MigLayout("insets 5 4 5 8, gap 10 0, novisualpadding", "[][grow, fill]", "[][]"));
        this.title = title;
        setName(title);
        picture = Icons.later(icon, ICON);
        heading = new StyledLabel(title + " heading", title, Font.BOLD, 0);
        this.detail = new StyledLabel(title + " detail", "", Font.PLAIN, -2);
        add(new JLabel(picture, SwingConstants.CENTER), "spany 2, w 30!, aligny center");
        add(heading, "wmin 0, wrap");
        add(this.detail, "wmin 0");
        addActionListener(event -> action.run());
        describe(detail);
        updateUI();
    }

    /** Reads the picture from its file; may block. */
    void readPicture() {
        Icons.read(picture);
    }

    /** Shows another explanation. */
    void describe(String text) {
        detail.setText(text);
        setToolTipText(text);
        getAccessibleContext().setAccessibleName(title);
        getAccessibleContext().setAccessibleDescription(text);
    }

    @Override
    public void setEnabled(boolean enabled) {
        super.setEnabled(enabled);
        heading.setEnabled(enabled);
        detail.setEnabled(enabled);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (detail != null) {
            detail.setForeground(Palette.faint());
        }
    }

    @Override
    public java.awt.Dimension getPreferredSize() {
        return getLayout() == null ? super.getPreferredSize() : getLayout().preferredLayoutSize(this);
    }

    @Override
    public java.awt.Dimension getMinimumSize() {
        return getLayout() == null ? super.getMinimumSize() : getLayout().minimumLayoutSize(this);
    }
}
