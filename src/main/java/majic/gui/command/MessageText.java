package majic.gui.command;

import java.awt.Font;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JPopupMenu;
import javax.swing.JTextPane;
import javax.swing.UIManager;
import javax.swing.text.DefaultCaret;
import javax.swing.text.EditorKit;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/** Shows a {@link MessageDocument}. It does not scroll when text is added, and leaves typed letters to the window. */
final class MessageText extends JTextPane {
    private static final Texts TEXTS = Texts.of(MessageText.class);
    private static final long serialVersionUID = 1L;
    private static final int SMALLEST = -4;
    private static final int LARGEST = 16;

    private int larger;
    private int menuOffset;
    private transient @Nullable Supplier<JPopupMenu> menu;

    /**
     * Creates a text.
     *
     * @param menu makes the context menu when it is first opened
     */
    MessageText(Supplier<JPopupMenu> menu) {
        this.menu = menu;
        setName("messages");
        setEditable(false);
        setBorder(BorderFactory.createEmptyBorder(6, 8, 6, 8));
        getAccessibleContext().setAccessibleName(TEXTS.get("messages"));
    }

    @Override
    protected EditorKit createDefaultEditorKit() {
        return new WrappingKit();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setKeymap(null);
        DefaultCaret caret = new StillCaret();
        setCaret(caret);
        setLarger(larger);
    }

    int larger() {
        return larger;
    }

    /** Sets how many points the text is larger than usual; limited to sizes that can be read. */
    void setLarger(int points) {
        larger = Math.max(SMALLEST, Math.min(LARGEST, points));
        Font usual = UIManager.getFont("monospaced.font");
        if (usual != null) {
            setFont(usual.deriveFont(usual.getSize2D() + larger));
        }
    }

    @Override
    public @Nullable JPopupMenu getComponentPopupMenu() {
        if (menu != null) {
            setComponentPopupMenu(menu.get());
            menu = null;
        }
        return super.getComponentPopupMenu();
    }

    /** Returns the place in the text at which the context menu was opened last. */
    int menuOffset() {
        return menuOffset;
    }

    @Override
    public @Nullable Point getPopupLocation(@Nullable MouseEvent event) {
        Point2D place = event == null ? null : event.getPoint();
        menuOffset = place == null ? getCaretPosition() : viewToModel2D(place);
        return super.getPopupLocation(event);
    }

    /** Scrolls only while the mouse is dragged, which the component does itself. */
    private static final class StillCaret extends DefaultCaret {
        private static final long serialVersionUID = 1L;

        @Override
        protected void adjustVisibility(Rectangle location) {}
    }
}
