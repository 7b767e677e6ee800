package majic.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.event.MouseWheelEvent;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.SwingConstants;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.text.NumberText;
import majic.text.Texts;
import net.miginfocom.layout.AC;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/**
 * A slider for a value that is set and measured: its name, the knob, the reading. The knob follows the measured value,
 * except while it is dragged, and until the chosen value is reached. The arrow keys, the wheel and a drag by a pixel
 * move it by one unit at most. Must be used on the event dispatch thread.
 */
public final class SetpointSlider extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int KNOB_ROOM = 48;

    /** Pixels by which text may be wider on a screen of another scale than measured. */
    private static final int TEXT_RESERVE = 4;

    private static final Texts TEXTS = Texts.of(SetpointSlider.class);

    private final String unit;
    private final JSlider slider;
    private final JLabel name;
    private final JLabel reading;
    private final transient SetpointListener listener;
    private boolean following;

    /** Receives the value chosen with the slider. */
    @FunctionalInterface
    public interface SetpointListener {
        /**
         * Sets a chosen value.
         *
         * @param value in the parameter's unit
         * @param last whether the knob was released
         */
        void setpointChanged(double value, boolean last);
    }

    /**
     * Creates a slider that has no reading yet.
     *
     * @param parameter gives name, unit, range and help
     * @param positiveLeft whether values grow to the left, as turns do
     * @param listener called on the event dispatch thread; must not block
     */
    public SetpointSlider(Parameter parameter, boolean positiveLeft, SetpointListener listener) {
        super(new MigLayout("insets 0, fillx, gap 4 0, novisualpadding", "[][grow, fill][right]", "[center]"));
        this.listener = listener;
        this.unit = parameter.unit().symbol();
        Range range = parameter.range();
        this.slider = new FineSlider((int) Math.round(range.min()), (int) Math.round(range.max()));
        this.name = new JLabel(ReadingText.label(parameter.name()));
        this.reading = new JLabel("–", SwingConstants.TRAILING);
        setOpaque(false);
        slider.setInverted(positiveLeft);
        slider.setName("slider " + parameter.name());
        slider.setToolTipText(TEXTS.get("slider.tip", parameter.help(), parameter.name(), inUnit(1)));
        name.setToolTipText(slider.getToolTipText());
        slider.setPreferredSize(new Dimension(UIScale.scale(KNOB_ROOM), slider.getPreferredSize().height));
        slider.setMinimumSize(new Dimension(UIScale.scale(KNOB_ROOM), slider.getPreferredSize().height));
        name.setLabelFor(slider);
        slider.addChangeListener(change -> changed());
        slider.addMouseWheelListener(this::turned);
        reading.setName(parameter.name());
        reading.setFocusable(true);
        PlotLink.install(reading, List.of(parameter.name()));
        add(name, "growx");
        add(slider);
        add(reading);
    }

    /**
     * Sets the label, which is the parameter's name in plain English words otherwise.
     *
     * @param label a few words in the user's language
     * @return this slider
     */
    public SetpointSlider labelled(String label) {
        name.setText(label);
        return this;
    }

    /**
     * Aligns sliders below each other: their names and readings get the same widths.
     *
     * @param sliders all that stand below each other
     */
    public static void align(Iterable<SetpointSlider> sliders) {
        int names = 0;
        int readings = 0;
        for (SetpointSlider one : sliders) {
            names = Math.max(names, one.name.getPreferredSize().width + TEXT_RESERVE);
            readings = Math.max(readings, one.widestReading());
        }
        AC columns = new AC()
                .size(unscaled(names), 0)
                .grow(100f, 1)
                .fill(1)
                .size(unscaled(readings), 2)
                .align("right", 2);
        for (SetpointSlider one : sliders) {
            ((MigLayout) one.getLayout()).setColumnConstraints(columns);
        }
    }

    /** Returns the fixed size of a column, in the pixels of a layout, which are scaled with the font. */
    private static String unscaled(int pixels) {
        return (int) Math.ceil(pixels / UIScale.getUserScaleFactor()) + "!";
    }

    private int widestReading() {
        FontMetrics metrics = reading.getFontMetrics(reading.getFont());
        int end = Math.max(
                metrics.stringWidth(inUnit(slider.getMinimum())), metrics.stringWidth(inUnit(slider.getMaximum())));
        return end + TEXT_RESERVE;
    }

    private String inUnit(int value) {
        return ReadingText.degrees(NumberText.of(value) + " " + unit);
    }

    /** Moves the knob by one unit for each notch of the wheel, which is finer than a pixel of a short slider. */
    private void turned(MouseWheelEvent event) {
        if (slider.isEnabled()) {
            slider.setValue(slider.getValue() - event.getWheelRotation());
        }
    }

    private void changed() {
        if (!following) {
            listener.setpointChanged(slider.getValue(), !slider.getValueIsAdjusting());
        }
    }

    /**
     * Shows the measured value.
     *
     * @param words the reading with its unit
     * @param value the same for the knob; null leaves it where it is
     * @param chosen whether a chosen value is not yet reached, so that the knob stays on it
     */
    public void show(String words, @Nullable Double value, boolean chosen) {
        reading.setText(words);
        if (value != null && !chosen && !slider.getValueIsAdjusting()) {
            following = true;
            slider.setValue((int) Math.round(value));
            following = false;
        }
    }

    /**
     * Shows whether the measured value is current; an older one is greyed.
     *
     * @param current whether it is current
     */
    public void setCurrent(boolean current) {
        reading.setEnabled(current);
    }

    @Override
    public void setEnabled(boolean enabled) {
        super.setEnabled(enabled);
        slider.setEnabled(enabled);
    }
}
