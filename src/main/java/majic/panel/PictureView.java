package majic.panel;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import org.jspecify.annotations.Nullable;

/**
 * Shows a robot's camera picture, as large as the space allows, with a caption in its corner; or a reason why there is
 * no picture, over the faded last picture if there was one. Must be used on the event dispatch thread.
 */
public final class PictureView extends JPanel {
    private static final long serialVersionUID = 1;
    private static final float FADED = 0.25f;
    private static final int INSET = 4;

    private transient @Nullable BufferedImage image;
    private String caption = "";
    private String words = "";

    /**
     * Creates an empty view.
     *
     * @param width of the pictures, pixels
     * @param height of the pictures, pixels
     */
    public PictureView(int width, int height) {
        setOpaque(false);
        setPreferredSize(new Dimension(width, height));
        setName("camera");
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
        getAccessibleContext().setAccessibleName("camera, " + newCaption);
        repaint();
    }

    /**
     * Shows why there is no picture.
     *
     * @param why a few words
     */
    public void miss(String why) {
        words = why;
        caption = "";
        getAccessibleContext().setAccessibleName("camera, " + why);
        repaint();
    }

    /** Returns the area that pictures fill; it keeps their aspect ratio. */
    private Rectangle2D frame() {
        BufferedImage shown = image;
        Dimension shape = shown == null ? getPreferredSize() : new Dimension(shown.getWidth(), shown.getHeight());
        double scale = Math.min((double) getWidth() / shape.width, (double) getHeight() / shape.height);
        double width = shape.width * scale;
        double height = shape.height * scale;
        return new Rectangle2D.Double((getWidth() - width) / 2, 0, width, height);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors.prepare(pen);
        DrawingColors colors = DrawingColors.current();
        Rectangle2D frame = frame();
        pen.setColor(colors.grey(0.12));
        pen.fill(frame);
        BufferedImage shown = image;
        if (shown != null) {
            paintImage(pen, shown, frame);
        }
        if (!words.isEmpty()) {
            pen.setColor(DrawingColors.translucent(colors.grey(0.12), 1 - FADED));
            pen.fill(frame);
            paintWords(pen, colors, frame);
        }
        if (!caption.isEmpty()) {
            paintCaption(pen, colors, frame);
        }
        pen.setColor(colors.grey(0.35));
        pen.setStroke(DrawingColors.stroke(1));
        pen.draw(frame);
        pen.dispose();
    }

    private static void paintImage(Graphics2D pen, BufferedImage shown, Rectangle2D frame) {
        pen.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        pen.drawImage(
                shown,
                (int) Math.round(frame.getX()),
                (int) Math.round(frame.getY()),
                (int) Math.round(frame.getWidth()),
                (int) Math.round(frame.getHeight()),
                null);
    }

    private void paintWords(Graphics2D pen, DrawingColors colors, Rectangle2D frame) {
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
        for (String word : words.split(" ")) {
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

    private void paintCaption(Graphics2D pen, DrawingColors colors, Rectangle2D frame) {
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
}
