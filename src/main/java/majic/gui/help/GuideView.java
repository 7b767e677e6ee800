package majic.gui.help;

import java.awt.Color;
import java.awt.Font;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.io.StringReader;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JEditorPane;
import javax.swing.JScrollPane;
import javax.swing.UIManager;
import javax.swing.text.BadLocationException;
import javax.swing.text.Element;
import javax.swing.text.StyleConstants;
import javax.swing.text.html.HTML;
import javax.swing.text.html.HTMLDocument;
import javax.swing.text.html.HTMLEditorKit;
import javax.swing.text.html.StyleSheet;
import majic.gui.kit.EventThread;
import majic.gui.kit.Palette;
import org.jspecify.annotations.Nullable;

/**
 * Shows pages of the documents, one below the other. They are read in the background, and their sections are added one
 * by one in pieces of the event dispatch thread, because their layout takes a second.
 */
final class GuideView extends JScrollPane {
    private static final long serialVersionUID = 1L;

    private final transient List<String> names;
    private final String title;
    private final JEditorPane text = new JEditorPane();
    private transient volatile @Nullable GuidePage page;
    private @Nullable String wanted;
    private String section = "";
    private transient @Nullable HTMLEditorKit newest;

    /**
     * Creates an empty view.
     *
     * @param names the files of the pages
     * @param title its accessible name
     */
    GuideView(List<String> names, String title) {
        this.names = names;
        this.title = title;
        text.setEditable(false);
        text.setName("guide " + names.get(0));
        text.setBorder(BorderFactory.createEmptyBorder(4, 12, 8, 12));
        setViewportView(text);
        // Without it, the text becomes narrower while it grows, and all of it is laid out again.
        setVerticalScrollBarPolicy(VERTICAL_SCROLLBAR_ALWAYS);
    }

    /** Shows the parts of the pages that contain a text; all of them for an empty text. */
    void search(String newWanted) {
        wanted = newWanted;
        render(newWanted);
    }

    /** Shows a section at the top whenever all sections are shown. */
    void scrollTo(String newSection) {
        section = newSection;
    }

    /** Renders the pages again in the colours of the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (text != null && wanted != null) {
            render(wanted);
        }
    }

    private void render(String words) {
        HTMLEditorKit kit = new HTMLEditorKit();
        newest = kit;
        EventThread.background("reading the guide", () -> {
            kit.setStyleSheet(styles(kit.getStyleSheet()));
            List<String> sections = pages().html(words);
            HTMLDocument document = document(kit, sections.get(0));
            EventThread.later(() -> {
                if (kit == newest) {
                    show(kit, document, sections);
                }
            });
        });
    }

    private GuidePage pages() {
        GuidePage known = page;
        if (known == null) {
            known = GuidePage.read(names);
            page = known;
        }
        return known;
    }

    private static HTMLDocument document(HTMLEditorKit kit, String html) {
        HTMLDocument document = (HTMLDocument) kit.createDefaultDocument();
        try {
            kit.read(new StringReader("<html><body>" + html + "</body></html>"), document, 0);
        } catch (IOException | BadLocationException e) {
            throw new IllegalStateException(e);
        }
        return document;
    }

    private void show(HTMLEditorKit kit, HTMLDocument document, List<String> sections) {
        text.setEditorKit(kit);
        text.getAccessibleContext().setAccessibleName(title);
        text.setDocument(document);
        text.setCaretPosition(0);
        addFrom(1, kit, document, sections);
    }

    /** Adds the sections from one on, as long as nothing else is to be shown. */
    private void addFrom(int first, HTMLEditorKit kit, HTMLDocument document, List<String> sections) {
        if (kit != newest) {
            return;
        }
        if (first == sections.size()) {
            if (wanted != null && wanted.isEmpty()) {
                scroll();
            }
            return;
        }
        Element body =
                document.getElement(document.getDefaultRootElement(), StyleConstants.NameAttribute, HTML.Tag.BODY);
        try {
            document.insertBeforeEnd(body, sections.get(first));
        } catch (IOException | BadLocationException e) {
            throw new IllegalStateException(e);
        }
        EventThread.piece(() -> addFrom(first + 1, kit, document, sections));
    }

    private void scroll() {
        try {
            Element heading = ((HTMLDocument) text.getDocument()).getElement(section);
            Rectangle2D place = heading == null ? null : text.modelToView2D(heading.getStartOffset());
            if (place != null) {
                text.scrollRectToVisible(
                        new Rectangle(0, (int) place.getY(), 1, getViewport().getHeight()));
            }
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);
        }
    }

    private static StyleSheet styles(StyleSheet base) {
        StyleSheet styles = new StyleSheet();
        styles.addStyleSheet(base);
        Font font = UIManager.getFont("Label.font");
        styles.addRule("body { font-family: " + font.getFamily() + "; }");
        styles.addRule("body { font-size: " + font.getSize() + "px; }");
        styles.addRule("body { color: " + hex(Palette.text()) + "; }");
        styles.addRule("a, address { color: " + hex(Palette.link()) + "; }");
        styles.addRule("ul, ol { margin-left: 20px; }");
        styles.addRule("h1 { font-size: 1.6em; } h2 { font-size: 1.3em; } h3 { font-size: 1.1em; }");
        styles.addRule("h2 { margin-top: 18px; margin-bottom: 4px; } h3 { margin-top: 14px; margin-bottom: 4px; }");
        styles.addRule("p { margin-top: 4px; margin-bottom: 6px; }");
        styles.addRule("code, pre { font-family: monospaced; }");
        styles.addRule("code { color: " + hex(Palette.command()) + "; }");
        styles.addRule("pre { color: " + hex(Palette.command()) + "; }");
        return styles;
    }

    private static String hex(Color color) {
        return String.format("#%06x", color.getRGB() & 0xFFFFFF);
    }
}
