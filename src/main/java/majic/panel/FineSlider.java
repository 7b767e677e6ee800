package majic.panel;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.ui.FlatSliderUI;
import java.awt.event.MouseEvent;
import javax.swing.JSlider;
import javax.swing.UIManager;

/**
 * A horizontal slider that can be dragged to each of its values: a drag by a pixel moves the knob by one unit at most,
 * however short the slider is. The mouse may then be ahead of the knob. Must be used on the event dispatch thread.
 */
final class FineSlider extends JSlider {
    private static final long serialVersionUID = 1;

    FineSlider(int min, int max) {
        super(min, max, Math.max(min, Math.min(0, max)));
    }

    /** Uses the look and feel's own slider if that is not FlatLaf. */
    @Override
    public void updateUI() {
        if (UIManager.getLookAndFeel() instanceof FlatLaf) {
            setUI(new FineUi());
        } else {
            super.updateUI();
        }
    }

    private static final class FineUi extends FlatSliderUI {
        @Override
        protected TrackListener createTrackListener(JSlider slider) {
            return new FineTrackListener();
        }

        /** Measures a drag from where it began. */
        private final class FineTrackListener extends FlatTrackListener {
            private int fromX;
            private int fromValue;

            @Override
            public void mousePressed(MouseEvent event) {
                super.mousePressed(event);
                fromX = event.getX();
                fromValue = slider.getValue();
            }

            @Override
            public void mouseDragged(MouseEvent event) {
                boolean isShort = slider.getMaximum() - slider.getMinimum() > trackRect.width;
                if (isShort && isDragging()) {
                    int pixels = event.getX() - fromX;
                    slider.setValueIsAdjusting(true);
                    slider.setValue(fromValue + (drawInverted() ? -pixels : pixels));
                    calculateThumbLocation();
                    slider.repaint();
                } else {
                    super.mouseDragged(event);
                }
            }
        }
    }
}
