package majic.panel;

import javax.swing.JLabel;

/**
 * One condition of a robot, told by a word and by a shape beside it; colour only adds to them. For the event dispatch
 * thread.
 */
public final class Light extends JLabel {
    private static final long serialVersionUID = 1;

    /** How much attention a condition wants. */
    public enum Kind {
        /** Nothing to tell: a ring. */
        QUIET,
        /** In working order: a disc. */
        GOOD,
        /** Worth a look: a triangle. */
        WARNING,
        /** In the way of moving on: an octagon with a cross. */
        ALARM
    }

    /**
     * A light that is quiet.
     *
     * @param name of the condition, for tests and screen readers
     * @param tip what the condition means
     */
    public Light(String name, String tip) {
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
        setIcon(LightIcon.of(kind));
        setText(words);
        getAccessibleContext().setAccessibleDescription(getToolTipText());
    }

    /**
     * How much attention it wants now.
     *
     * @return what was shown last
     */
    public Kind kind() {
        return ((LightIcon) getIcon()).kind();
    }
}
