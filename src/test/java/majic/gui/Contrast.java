package majic.gui;

import java.awt.Color;

/** The contrast ratio of WCAG 2.1. */
public final class Contrast {
    /** Success criterion 1.4.3: minimum contrast of text. */
    public static final double TEXT = 4.5;

    /** Success criterion 1.4.11: minimum contrast of graphics. */
    public static final double SHAPES = 3;

    private Contrast() {}

    /** Returns the contrast ratio of two opaque colours: 1 to 21. */
    public static double of(Color one, Color other) {
        double a = luminance(one) + 0.05;
        double b = luminance(other) + 0.05;
        return Math.max(a, b) / Math.min(a, b);
    }

    private static double luminance(Color color) {
        return 0.2126 * linear(color.getRed()) + 0.7152 * linear(color.getGreen()) + 0.0722 * linear(color.getBlue());
    }

    private static double linear(int channel) {
        double share = channel / 255.0;
        return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }
}
