package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButton;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JTable;
import javax.swing.JToggleButton;
import javax.swing.JToolTip;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import javax.swing.plaf.basic.BasicHTML;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.tree.DefaultTreeCellRenderer;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class PlainTextUiTest {
    private static final String HOSTILE = "<HTML><img src='http://192.0.2.1/robot.png'>STOP";

    @BeforeEach
    void install() {
        GuiActionRunner.execute(() -> {
            FlatLightLaf.setup();
            PlainTextUi.install();
        });
    }

    /** Makes a component that shows a text; its name is that of the test. */
    private record Kind(String name, Function<String, JComponent> make) {
        @Override
        public String toString() {
            return name;
        }
    }

    static Stream<Kind> kinds() {
        return Stream.of(
                new Kind("label", JLabel::new),
                new Kind("button", JButton::new),
                new Kind("toggle button", JToggleButton::new),
                new Kind("check box", JCheckBox::new),
                new Kind("radio button", JRadioButton::new),
                new Kind("menu", JMenu::new),
                new Kind("menu item", JMenuItem::new),
                new Kind("check box in a menu", JCheckBoxMenuItem::new),
                new Kind("radio button in a menu", JRadioButtonMenuItem::new),
                new Kind("cell of a list", PlainTextUiTest::listCell),
                new Kind("cell of a table", PlainTextUiTest::tableCell),
                new Kind("header of a table", PlainTextUiTest::tableHeader),
                new Kind("cell of a tree", PlainTextUiTest::treeCell),
                new Kind("tooltip", PlainTextUiTest::tooltip));
    }

    private static JComponent listCell(String text) {
        return (JComponent)
                new DefaultListCellRenderer().getListCellRendererComponent(new JList<>(), text, 0, false, false);
    }

    private static JComponent tableCell(String text) {
        return (JComponent)
                new DefaultTableCellRenderer().getTableCellRendererComponent(new JTable(), text, false, false, 0, 0);
    }

    private static JComponent tableHeader(String text) {
        JTable table = new JTable(new Object[1][1], new Object[] {text});
        return (JComponent) table.getTableHeader()
                .getDefaultRenderer()
                .getTableCellRendererComponent(table, text, false, false, -1, 0);
    }

    private static JComponent treeCell(String text) {
        return (JComponent) new DefaultTreeCellRenderer()
                .getTreeCellRendererComponent(new JTree(), text, false, false, true, 0, false);
    }

    private static JComponent tooltip(String text) {
        JToolTip tip = new JLabel().createToolTip();
        tip.setTipText(text);
        return tip;
    }

    private static boolean isHtml(JComponent component) {
        return component.getClientProperty(BasicHTML.propertyKey) != null;
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void noComponentInterpretsATextAsHtmlInAnyLook(Kind kind) {
        GuiActionRunner.execute(() -> {
            JComponent component = kind.make().apply(HOSTILE);
            assertThat(isHtml(component)).isFalse();
            FlatDarkLaf.setup();
            SwingUtilities.updateComponentTreeUI(component);
            assertThat(isHtml(component)).isFalse();
            assertThat(FlatLaf.isLafDark()).isTrue();
        });
    }

    @Test
    void aComponentThatShowsHtmlOfTheProgramSaysSo() {
        GuiActionRunner.execute(() -> {
            AbstractButton button = new JButton();
            button.putClientProperty("html.disable", false);
            button.setText("<html><b>bold</b>");
            assertThat(isHtml(button)).isTrue();
            SwingUtilities.updateComponentTreeUI(button);
            assertThat(isHtml(button)).isTrue();
        });
    }

    @Test
    void theTitleOfATabNeverBeginsAsHtml() {
        assertThat(PlainTextUi.title(HOSTILE)).isEqualTo(" " + HOSTILE);
        assertThat(PlainTextUi.title("lap.majic")).isEqualTo("lap.majic");
    }
}
