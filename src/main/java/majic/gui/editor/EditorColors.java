package majic.gui.editor;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;
import java.awt.Font;
import java.util.Map;
import javax.swing.UIManager;
import majic.gui.kit.Palette;
import majic.panel.DrawingColors;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.Style;
import org.fife.ui.rsyntaxtextarea.SyntaxScheme;
import org.fife.ui.rtextarea.Gutter;

/**
 * The colours of a script in the present look and feel. Immutable.
 *
 * @param paper the background of the text
 * @param running the background of a line that runs
 * @param next the background of the line that runs next
 * @param types for each type of {@link ScriptTokens} the colour of its text
 */
record EditorColors(Color paper, Color running, Color next, Map<Integer, Color> types) {
    static EditorColors current() {
        return FlatLaf.isLafDark() ? dark() : light();
    }

    private static EditorColors light() {
        return new EditorColors(
                UIManager.getColor("TextArea.background"),
                new Color(0xDFF3E3),
                new Color(0xFFF3CC),
                types(0x7B2D9B, 0x0B6340, 0xA01A58, 0x8A4500, 0x5B656D));
    }

    private static EditorColors dark() {
        return new EditorColors(
                new Color(0x2E3133),
                new Color(0x1F4029),
                new Color(0x4A3D12),
                types(0xD9AEF5, 0x8BD9AC, 0xFFA8C5, 0xF0BC7C, 0xAAB4BC));
    }

    private static Map<Integer, Color> types(int robots, int numbers, int values, int texts, int comments) {
        Color words = Palette.command();
        return Map.ofEntries(
                Map.entry(ScriptTokens.COMMAND, words),
                Map.entry(ScriptTokens.OWN_COMMAND, words),
                Map.entry(ScriptTokens.JOINT, words),
                Map.entry(ScriptTokens.ROBOT, new Color(robots)),
                Map.entry(ScriptTokens.NUMBER, new Color(numbers)),
                Map.entry(ScriptTokens.VALUE, new Color(values)),
                Map.entry(ScriptTokens.TEXT, new Color(texts)),
                Map.entry(ScriptTokens.OPEN_TEXT, Palette.error()),
                Map.entry(ScriptTokens.COMMENT, new Color(comments)),
                Map.entry(ScriptTokens.NAME, Palette.text()),
                Map.entry(ScriptTokens.SIGN, Palette.text()));
    }

    /** Sets font and colours of a text and its line numbers. */
    void apply(RSyntaxTextArea area, Gutter gutter) {
        Font font = UIManager.getFont("monospaced.font");
        SyntaxScheme scheme = new SyntaxScheme(font, false);
        for (Style style : scheme.getStyles()) {
            if (style != null) {
                style.foreground = Palette.text();
                style.background = null;
                style.font = null;
            }
        }
        types.forEach((type, color) -> scheme.getStyle(type).foreground = color);
        scheme.getStyle(ScriptTokens.COMMAND).font = font.deriveFont(Font.BOLD);
        scheme.getStyle(ScriptTokens.COMMENT).font = font.deriveFont(Font.ITALIC);
        scheme.getStyle(ScriptTokens.OPEN_TEXT).underline = true;
        area.setFont(font);
        area.setSyntaxScheme(scheme);
        area.setBackground(paper);
        area.setForeground(Palette.text());
        area.setCaretColor(Palette.text());
        area.setSelectionColor(UIManager.getColor("TextArea.selectionBackground"));
        area.setSelectedTextColor(UIManager.getColor("TextArea.selectionForeground"));
        area.setUseSelectedTextColor(true);
        area.setCurrentLineHighlightColor(DrawingColors.translucent(Palette.text(), 0.05));
        area.setMarkAllHighlightColor(next);
        area.setMatchedBracketBGColor(Palette.mixed(0.2));
        area.setMatchedBracketBorderColor(Palette.mixed(0.4));
        gutter.setBackground(paper);
        gutter.setIconRowHeaderInheritsGutterBackground(true);
        gutter.setBorderColor(Palette.mixed(0.15));
        gutter.setLineNumberColor(Palette.faint());
        gutter.setCurrentLineNumberColor(Palette.text());
        gutter.setLineNumberFont(font);
    }
}
