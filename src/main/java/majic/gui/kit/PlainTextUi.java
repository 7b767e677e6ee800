package majic.gui.kit;

import java.util.List;
import javax.swing.JComponent;
import javax.swing.UIManager;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicHTML;

/**
 * Makes labels, buttons, menu items, cells of tables and lists, and tooltips show their texts as they are. Swing
 * interprets a text that begins with {@code <html>}, so that a text of a robot, a file or another computer could load
 * pictures over the network and imitate other parts of the window. A component that shows HTML of the program itself
 * sets the client property {@code html.disable} to false. Must be used on the event dispatch thread.
 */
public final class PlainTextUi extends ComponentUI {
    private static final String DISABLE = "html.disable";

    /** Without tabbed panes, which ignore the property in Java 17; see {@link #title}. */
    private static final List<String> KINDS = List.of(
            "LabelUI",
            "ToolTipUI",
            "ButtonUI",
            "ToggleButtonUI",
            "CheckBoxUI",
            "RadioButtonUI",
            "MenuUI",
            "MenuItemUI",
            "CheckBoxMenuItemUI",
            "RadioButtonMenuItemUI");

    private PlainTextUi() {}

    /** Makes all components that are created from now on show plain text, with any look and feel. */
    public static void install() {
        UIManager.put(PlainTextUi.class.getName(), PlainTextUi.class);
        KINDS.forEach(kind -> UIManager.put(kind, PlainTextUi.class.getName()));
    }

    /**
     * Switches HTML off in a component, and returns what the look and feel provides for it. Swing calls this method for
     * each component.
     */
    public static ComponentUI createUI(JComponent component) {
        if (component.getClientProperty(DISABLE) == null) {
            component.putClientProperty(DISABLE, true);
        }
        return UIManager.getLookAndFeelDefaults().getUI(component);
    }

    /** Returns a text as the title of a tab: one that Swing would interpret as HTML begins with a blank. */
    public static String title(String text) {
        return BasicHTML.isHTMLString(text) ? " " + text : text;
    }
}
