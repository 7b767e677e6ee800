package majic.gui.start;

import java.awt.BorderLayout;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.SwingConstants;
import majic.gui.kit.Icons;
import majic.gui.kit.Palette;
import majic.gui.kit.Pictogram;
import majic.gui.kit.StyledLabel;

/** A large button of the start page: picture, title and one line of explanation. */
final class StartButton extends JButton {
    private static final long serialVersionUID = 1L;
    private static final int ICON = 26;

    private final String title;
    private final JLabel detail;
    private final JLabel heading;
    private final JLabel picture;

    StartButton(String title, String detail, Pictogram icon, Runnable action) {
        super.setLayout(new BorderLayout(10, 0));
        this.title = title;
        setName(title);
        heading = new StyledLabel(title + " heading", title, Font.BOLD, 0);
        this.detail = new StyledLabel(title + " detail", "", Font.PLAIN, -2);
        picture = new JLabel(Icons.of(icon, ICON), SwingConstants.CENTER);
        picture.setDisabledIcon(picture.getIcon());
        picture.setBorder(BorderFactory.createEmptyBorder(0, 6, 0, 2));
        Box texts = Box.createVerticalBox();
        texts.setBorder(BorderFactory.createEmptyBorder(5, 0, 5, 8));
        texts.add(heading);
        texts.add(this.detail);
        add(picture, BorderLayout.WEST);
        add(texts, BorderLayout.CENTER);
        addActionListener(event -> action.run());
        describe(detail);
        updateUI();
    }

    /** Shows another explanation. */
    void describe(String text) {
        detail.setText(text);
        setToolTipText(text);
        getAccessibleContext().setAccessibleName(title);
        getAccessibleContext().setAccessibleDescription(text);
    }

    /** Shows or hides the line of explanation. */
    void showDetail(boolean shown) {
        detail.setVisible(shown);
    }

    /** Returns by how much the button grows when its explanation is shown, pixels; 0 while it is shown. */
    int hiddenHeight() {
        return detail.isVisible() ? 0 : detail.getPreferredSize().height;
    }

    @Override
    public void setEnabled(boolean enabled) {
        super.setEnabled(enabled);
        picture.setEnabled(enabled);
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
