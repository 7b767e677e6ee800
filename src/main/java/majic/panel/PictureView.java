package majic.panel;

import java.awt.Container;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import majic.text.ErrorWords;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * Shows a robot's camera picture, as large as the space allows, with a caption in its corner; or a reason why there is
 * no current picture, over the faded last one if there was one. A click, Enter or Space asks the surrounding
 * {@link PictureViewer} for a larger view. Must be used on the event dispatch thread.
 */
public final class PictureView extends JPanel {
    private static final long serialVersionUID = 1;
    private static final float FADED = 0.25f;
    private static final int INSET = 4;
    private static final Texts TEXTS = Texts.of(PictureView.class);

    private final transient PictureView source;
    private final transient Set<PictureView> copies = new LinkedHashSet<>();
    private final transient VisibilityWatch visibility;
    private transient Consumer<Boolean> watchListener = seen -> {};
    private transient Supplier<String> title = () -> TEXTS.get("camera");
    private transient @Nullable BufferedImage image;
    private String caption = "";
    private String words = "";
    private boolean current = true;
    private int watched;

    /**
     * Creates an empty view.
     *
     * @param width of the pictures, pixels
     * @param height of the pictures, pixels
     */
    public PictureView(int width, int height) {
        this(new Dimension(width, height), null);
        setName("camera");
        setFocusable(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                enlarge();
            }
        });
        KeyAction.bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke("ENTER"), event -> enlarge());
        KeyAction.bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke("SPACE"), event -> enlarge());
        addFocusListener(new RepaintOnFocus());
    }

    private PictureView(Dimension size, @Nullable PictureView original) {
        setOpaque(false);
        setPreferredSize(size);
        source = original == null ? this : original;
        visibility = new VisibilityWatch(this, seen -> source.watch(seen ? 1 : -1));
    }

    /**
     * Creates a view of the same pictures, of another size. It shows them while it is part of a window.
     *
     * @param width preferred, pixels
     * @param height preferred, pixels
     * @return the copy
     */
    public PictureView copy(int width, int height) {
        PictureView copy = new PictureView(new Dimension(width, height), source);
        copy.setName("largeCamera");
        copy.take(source);
        return copy;
    }

    /**
     * Sets what is called when the view, or one of its copies, becomes visible to the user, and when none is any more.
     *
     * @param listener receives true or false, on the event dispatch thread
     */
    public void whenWatched(Consumer<Boolean> listener) {
        watchListener = listener;
    }

    /**
     * Sets the title of a window with a larger view.
     *
     * @param newTitle returns the title when such a window is opened
     */
    public void setTitle(Supplier<String> newTitle) {
        title = newTitle;
    }

    /**
     * Returns the title of a window with a larger view.
     *
     * @return the word for a camera unless another title is set
     */
    public String title() {
        return title.get();
    }

    private void watch(int change) {
        boolean before = watched > 0;
        watched += change;
        if (before != watched > 0) {
            watchListener.accept(watched > 0);
        }
    }

    @Override
    public void addNotify() {
        super.addNotify();
        if (source != this) {
            source.copies.add(this);
            take(source);
        }
    }

    @Override
    public void removeNotify() {
        source.copies.remove(this);
        visibility.end();
        super.removeNotify();
    }

    /** Opens a larger view in the window that offers it. */
    private void enlarge() {
        for (Container place = getParent(); place != null; place = place.getParent()) {
            if (place instanceof PictureViewer viewer) {
                viewer.enlarge(this);
                return;
            }
        }
    }

    private void take(PictureView other) {
        image = other.image;
        caption = other.caption;
        words = other.words;
        current = other.current;
        getAccessibleContext().setAccessibleName(other.getAccessibleContext().getAccessibleName());
        repaint();
        copies.forEach(copy -> copy.take(this));
    }

    /**
     * Returns the picture shown now.
     *
     * @return must not be changed; empty if there was none yet
     */
    public Optional<BufferedImage> image() {
        return Optional.ofNullable(image);
    }

    /**
     * Shows a picture.
     *
     * @param newImage must not be changed afterwards
     * @param newCaption short; for instance the frame rate
     */
    public void show(BufferedImage newImage, String newCaption) {
        image = newImage;
        words = "";
        caption = newCaption;
        changed();
    }

    /**
     * Shows why there is no picture.
     *
     * @param why a few words
     */
    public void miss(String why) {
        words = ErrorWords.of(why);
        caption = "";
        changed();
    }

    /**
     * Shows whether the picture is current: without a connection, the last one is faded under words that say so.
     *
     * @param isCurrent whether it is current
     */
    public void setCurrent(boolean isCurrent) {
        if (current != isCurrent) {
            current = isCurrent;
            changed();
        }
    }

    private String shownWords() {
        return current ? words : TEXTS.get("camera.notConnected");
    }

    private String shownCaption() {
        return current ? caption : "";
    }

    private void changed() {
        getAccessibleContext().setAccessibleName(TEXTS.get("camera.shows", shownWords() + shownCaption()));
        repaint();
        copies.forEach(copy -> copy.take(this));
    }

    /** Returns the area that pictures fill, in whole pixels; it keeps their aspect ratio. */
    private Rectangle frame() {
        BufferedImage shown = image;
        Dimension shape = shown == null ? getPreferredSize() : new Dimension(shown.getWidth(), shown.getHeight());
        double scale = Math.min((double) getWidth() / shape.width, (double) getHeight() / shape.height);
        int width = (int) Math.round(shape.width * scale);
        int height = (int) Math.round(shape.height * scale);
        return new Rectangle((getWidth() - width) / 2, 0, width, height);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors.prepare(pen);
        DrawingColors colors = DrawingColors.current();
        Rectangle frame = frame();
        paintFrame(pen, colors, frame);
        if (!shownWords().isEmpty()) {
            pen.setColor(DrawingColors.translucent(colors.grey(0.12), 1 - FADED));
            pen.fill(frame);
            paintWords(pen, colors, frame);
        }
        if (!shownCaption().isEmpty()) {
            paintCaption(pen, colors, frame);
        }
        pen.dispose();
    }

    /**
     * Paints the picture, its background, which it may let through, and its border, all of them without smooth edges:
     * these cost more work than the picture.
     */
    private void paintFrame(Graphics2D pen, DrawingColors colors, Rectangle frame) {
        Graphics2D sharp = (Graphics2D) pen.create();
        sharp.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
        sharp.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        sharp.setColor(colors.grey(0.12));
        sharp.fill(frame);
        if (image != null) {
            sharp.drawImage(image, frame.x, frame.y, frame.width, frame.height, null);
        }
        sharp.setColor(isFocusOwner() ? colors.accent() : colors.grey(0.35));
        paintBorder(sharp, frame, isFocusOwner() ? 2 : 1);
        sharp.dispose();
    }

    private static void paintBorder(Graphics2D pen, Rectangle frame, int thick) {
        pen.fillRect(frame.x, frame.y, frame.width, thick);
        pen.fillRect(frame.x, frame.y + frame.height - thick, frame.width, thick);
        pen.fillRect(frame.x, frame.y, thick, frame.height);
        pen.fillRect(frame.x + frame.width - thick, frame.y, thick, frame.height);
    }

    private void paintWords(Graphics2D pen, DrawingColors colors, Rectangle frame) {
        FontMetrics metrics = pen.getFontMetrics();
        List<String> lines = lines(metrics, frame.getWidth() - 2 * INSET);
        double base = frame.getCenterY() - lines.size() * metrics.getHeight() / 2.0 + metrics.getAscent();
        pen.setColor(colors.line());
        for (String line : lines) {
            pen.drawString(line, (float) (frame.getCenterX() - metrics.stringWidth(line) / 2.0), (float) base);
            base += metrics.getHeight();
        }
    }

    private List<String> lines(FontMetrics metrics, double width) {
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String word : shownWords().split(" ")) {
            String longer = line.isEmpty() ? word : line + " " + word;
            if (!line.isEmpty() && metrics.stringWidth(longer) > width) {
                lines.add(line);
                longer = word;
            }
            line = longer;
        }
        lines.add(line);
        return lines;
    }

    private void paintCaption(Graphics2D pen, DrawingColors colors, Rectangle frame) {
        FontMetrics metrics = pen.getFontMetrics();
        double width = metrics.stringWidth(caption) + 2.0 * INSET;
        if (width + INSET > frame.getWidth()) {
            return;
        }
        double height = metrics.getHeight();
        double left = frame.getMaxX() - width - INSET;
        double top = frame.getMaxY() - height - INSET;
        pen.setColor(DrawingColors.translucent(colors.paper(), 0.8));
        pen.fill(new RoundRectangle2D.Double(left, top, width, height, INSET, INSET));
        pen.setColor(colors.line());
        pen.drawString(caption, (float) left + INSET, (float) top + metrics.getAscent());
    }

    /** Repaints the frame, which shows the focus. */
    private final class RepaintOnFocus implements FocusListener {
        @Override
        public void focusGained(FocusEvent event) {
            repaint();
        }

        @Override
        public void focusLost(FocusEvent event) {
            repaint();
        }
    }
}
