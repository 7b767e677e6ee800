package majic.gui;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.accessibility.AccessibleContext;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JPopupMenu;
import javax.swing.JProgressBar;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.JViewport;
import javax.swing.plaf.basic.BasicHTML;
import javax.swing.text.JTextComponent;
import majic.gui.kit.Paragraph;
import majic.text.MarkedTexts;

/**
 * Finds what a user cannot read or reach in a window or panel, shown or only laid out: components without an accessible
 * name, missing or double mnemonics, text with too little contrast. Call it on the event dispatch thread.
 */
public final class WindowAudit {
    private WindowAudit() {}

    /** Lists the components that show a text as HTML without saying that it is the program's own; see PlainTextUi. */
    static List<String> interpretingHtml(Container root) {
        return everything(root)
                .filter(part -> part instanceof JComponent component
                        && component.getClientProperty(BasicHTML.propertyKey) != null
                        && !Boolean.FALSE.equals(component.getClientProperty("html.disable")))
                .map(WindowAudit::describe)
                .toList();
    }

    private static Stream<Component> everything(Container root) {
        return Stream.of(root.getComponents())
                .flatMap(part -> Stream.concat(
                        Stream.of(part), part instanceof Container inner ? everything(inner) : Stream.empty()));
    }

    /** Lists the components that take the focus, a click or the place of a picture, and have no accessible name. */
    public static List<String> nameless(Container root) {
        return visible(root, part -> part instanceof JComboBox || part instanceof JFileChooser)
                .filter(WindowAudit::isReachable)
                .filter(part -> isBlank(part.getAccessibleContext().getAccessibleName()))
                .map(WindowAudit::describe)
                .toList();
    }

    private static boolean isReachable(Component part) {
        if (part instanceof JScrollPane
                || part instanceof JViewport
                || part instanceof JScrollBar
                || part instanceof JSplitPane
                || part.getClass().getName().startsWith("javax.swing.plaf")
                || part.getClass().getName().contains("FlatSplitPaneUI")
                || part.getClass().getName().contains("FlatTitlePane")
                || part.getClass().getName().contains("FlatScrollBarButton")) {
            return false;
        }
        boolean control = part instanceof AbstractButton
                || part instanceof JTextComponent
                || part instanceof JComboBox
                || part instanceof JList
                || part instanceof JTable
                || part instanceof JTree
                || part instanceof JSlider
                || part instanceof JProgressBar;
        boolean ours = part instanceof JComponent && part.getClass().getName().startsWith("majic");
        return control || ours && part.isFocusable() && hasKeys(part);
    }

    /** Returns whether a component reacts to keys when it has the focus. */
    private static boolean hasKeys(Component part) {
        return part.getKeyListeners().length > 0
                || ((JComponent) part).getInputMap().size() > 0;
    }

    /** Lists the labelled fields and buttons of a dialog that have no mnemonic, and the mnemonics used twice. */
    public static List<String> mnemonicProblems(Container root) {
        List<String> problems = new ArrayList<>();
        Set<Integer> used = new HashSet<>();
        visible(root, part -> part instanceof JComboBox || part instanceof JFileChooser || part instanceof JMenuBar)
                .forEach(part -> {
                    if (part instanceof AbstractButton button && !isBlank(button.getText())) {
                        check(button.getText(), button.getMnemonic(), used, problems);
                    } else if (part instanceof JLabel label && label.getLabelFor() != null) {
                        check(label.getText(), label.getDisplayedMnemonic(), used, problems);
                    } else if (part instanceof JTabbedPane tabs) {
                        IntStream.range(0, tabs.getTabCount())
                                .forEach(tab -> check(tabs.getTitleAt(tab), tabs.getMnemonicAt(tab), used, problems));
                    }
                });
        return problems;
    }

    /** Lists the same for the menus, and for the entries of each. */
    public static List<String> mnemonicProblems(JMenuBar bar) {
        List<String> problems = new ArrayList<>();
        List<JMenu> menus =
                IntStream.range(0, bar.getMenuCount()).mapToObj(bar::getMenu).toList();
        Set<Integer> used = new HashSet<>();
        menus.forEach(menu -> check(menu.getText(), menu.getMnemonic(), used, problems));
        menus.forEach(menu -> checkEntries(menu.getPopupMenu(), problems));
        return problems;
    }

    private static void checkEntries(JPopupMenu entries, List<String> problems) {
        Set<Integer> used = new HashSet<>();
        Stream.of(entries.getComponents())
                .filter(AbstractButton.class::isInstance)
                .map(AbstractButton.class::cast)
                .forEach(entry -> check(entry.getText(), entry.getMnemonic(), used, problems));
    }

    private static void check(String text, int mnemonic, Set<Integer> used, List<String> problems) {
        if (mnemonic <= 0) {
            problems.add(text + ": no mnemonic");
        } else if (!used.add(mnemonic)) {
            problems.add(text + ": " + (char) mnemonic + " is used twice");
        }
    }

    /** Lists the enabled texts whose contrast with their background is below a limit. */
    public static List<String> pale(Container root, double least) {
        return visible(root, part -> part instanceof JFileChooser)
                .filter(part -> part.isEnabled() && hasText(part))
                .filter(part -> Contrast.of(part.getForeground(), background(part)) < least)
                .map(part -> describe(part) + " " + hex(part.getForeground()) + " on " + hex(background(part)))
                .toList();
    }

    /**
     * Lists the texts that do not come from a resource bundle; to be called while texts are in
     * {@link MarkedTexts#LANGUAGE}.
     *
     * @param data what is no text: names, numbers, addresses, words of MAJIC Script
     */
    public static List<String> unmarked(Container root, Pattern data) {
        return visible(root, part -> part instanceof JComboBox || part instanceof JFileChooser)
                .flatMap(part -> texts(part)
                        .filter(text -> text != null && !isData(text, data))
                        .map(text -> part.getClass().getName() + " " + part.getName() + ": " + text))
                .distinct()
                .toList();
    }

    private static boolean isData(String text, Pattern data) {
        String rest = MarkedTexts.unmarked(text.replaceAll("<[^>]*>", " "));
        return data.matcher(rest).replaceAll("").codePoints().noneMatch(Character::isLetter);
    }

    /** Returns the texts of a component for the eye and for screen readers. */
    private static Stream<String> texts(Component part) {
        Stream.Builder<String> texts = Stream.builder();
        AccessibleContext access = part.getAccessibleContext();
        if (access != null) {
            texts.add(access.getAccessibleName()).add(access.getAccessibleDescription());
        }
        if (part instanceof JComponent component) {
            texts.add(component.getToolTipText());
        }
        if (part instanceof JMenu menu) {
            Stream.of(menu.getMenuComponents()).flatMap(WindowAudit::texts).forEach(texts::add);
        }
        if (part instanceof AbstractButton button) {
            texts.add(button.getText());
        } else if (part instanceof JLabel label) {
            texts.add(label.getText());
        } else if (part instanceof JTextComponent field) {
            texts.add((String) field.getClientProperty("JTextField.placeholderText"));
            texts.add(field instanceof Paragraph ? field.getText() : null);
        } else if (part instanceof JTabbedPane tabs) {
            IntStream.range(0, tabs.getTabCount()).mapToObj(tabs::getTitleAt).forEach(texts::add);
        } else if (part instanceof JTable table) {
            IntStream.range(0, table.getColumnCount())
                    .mapToObj(table::getColumnName)
                    .forEach(texts::add);
        }
        return texts.build();
    }

    private static boolean hasText(Component part) {
        return part instanceof JLabel label && !isBlank(label.getText())
                || part instanceof AbstractButton button && !isBlank(button.getText())
                || part instanceof JTextComponent text && !isBlank(text.getText());
    }

    private static Color background(Component part) {
        Component place = part;
        while (!place.isOpaque() && !isFilled(place) && place.getParent() != null) {
            place = place.getParent();
        }
        return place.getBackground();
    }

    private static boolean isFilled(Component place) {
        return place instanceof AbstractButton button
                && button.isContentAreaFilled()
                && !"toolBarButton".equals(button.getClientProperty("JButton.buttonType"));
    }

    private static Stream<Component> visible(Component root, Predicate<Component> closed) {
        if (!root.isVisible()) {
            return Stream.empty();
        }
        Stream<Component> self = Stream.of(root);
        return root instanceof Container container && !closed.test(root)
                ? Stream.concat(self, Stream.of(container.getComponents()).flatMap(part -> visible(part, closed)))
                : self;
    }

    private static String describe(Component part) {
        String text = part instanceof JLabel label
                ? label.getText()
                : part instanceof AbstractButton button ? button.getText() : "";
        return part.getClass().getSimpleName() + " " + part.getName() + " " + text;
    }

    private static String hex(Color color) {
        return String.format("%06x", color.getRGB() & 0xFFFFFF);
    }

    private static boolean isBlank(String text) {
        return text == null || text.isBlank();
    }
}
