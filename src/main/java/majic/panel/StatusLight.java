package majic.panel;

import javax.swing.JLabel;

/**
 * Shows one condition of a robot as a word and a shape; colour only adds to them. A disabled light shows an old
 * condition: grey words and a ring. Must be used on the event dispatch thread.
 */
public final class StatusLight extends JLabel {
    private static final long serialVersionUID = 1;

    /** The severity of a condition. */
    public enum Kind {
        /** Nothing to report: a ring. */
        QUIET,
        /** In working order: a disc. */
        GOOD,
        /** Needs attention: a triangle. */
        WARNING,
        /** Prevents motion: an octagon with a cross. */
        ALARM
    }

    /**
     * Creates a light of kind {@link Kind#QUIET}.
     *
     * @param name of the condition, for tests and screen readers
     * @param tip what the condition means
     */
    public StatusLight(String name, String tip) {
        setName(name);
        setToolTipText(tip);
        setIconTextGap(5);
        show(Kind.QUIET, name);
    }

    /**
     * Shows the condition.
     *
     * @param kind its shape
     * @param words its words, short
     */
    public void show(Kind kind, String words) {
        setIcon(StatusLightIcon.of(kind));
        setDisabledIcon(StatusLightIcon.of(Kind.QUIET));
        setText(words);
        getAccessibleContext().setAccessibleDescription(getToolTipText());
    }

    /**
     * Returns the severity shown last.
     *
     * @return the kind given last
     */
    public Kind kind() {
        return ((StatusLightIcon) getIcon()).kind();
    }
}
