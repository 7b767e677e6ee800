import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TableCell;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.Heading;
import org.commonmark.node.Image;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.node.Paragraph;
import org.commonmark.node.SoftLineBreak;
import org.commonmark.node.Text;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

/**
 * Makes the pages that Help shows from the documents, in HTML as Swing displays it: without pictures, and with the text
 * of links only. Headings have the names that links use. The build calls it.
 */
final class GuideHtml {
    private static final List<Extension> TABLES = List.of(TablesExtension.create());

    private GuideHtml() {}

    /**
     * Makes the pages.
     *
     * @param args the folder of the documents, the folder for the pages, and the names of documents without ending or
     *     of folders of documents
     * @throws IOException if a document cannot be read or a page not be written
     */
    public static void main(String[] args) throws IOException {
        for (String name : List.of(args).subList(2, args.length)) {
            Path folder = Path.of(args[0], name);
            if (Files.isDirectory(folder)) {
                makeAll(folder, Path.of(args[1], name));
            } else {
                make(Path.of(args[0], name + ".md"), Path.of(args[1]));
            }
        }
    }

    private static void makeAll(Path folder, Path target) throws IOException {
        try (DirectoryStream<Path> documents = Files.newDirectoryStream(folder, "*.md")) {
            for (Path document : documents) {
                make(document, target);
            }
        }
    }

    private static void make(Path document, Path target) throws IOException {
        String name = document.getFileName().toString().replaceFirst("md$", "html");
        Files.writeString(Files.createDirectories(target).resolve(name), html(Files.readString(document)));
    }

    private static String html(String document) {
        Node page = Parser.builder().extensions(TABLES).build().parse(document);
        page.accept(new WithoutReferences());
        return HtmlRenderer.builder()
                .softbreak(" ")
                .extensions(TABLES)
                .attributeProviderFactory(context -> GuideHtml::setAttributes)
                .build()
                .render(page);
    }

    private static void setAttributes(Node node, String tag, Map<String, String> attributes) {
        if (node instanceof Heading heading) {
            attributes.put("id", name(heading));
        } else if (tag.equals("table")) {
            attributes.put("cellpadding", "4");
        } else if (node instanceof TableCell) {
            attributes.put("valign", "top");
            attributes.put("align", "left");
        }
    }

    /** Returns the name of a heading in links: lower case, without punctuation, words joined by {@code -}. */
    private static String name(Heading heading) {
        StringBuilder words = new StringBuilder();
        heading.accept(new AbstractVisitor() {
            @Override
            public void visit(Text text) {
                words.append(text.getLiteral());
            }

            @Override
            public void visit(Code code) {
                words.append(code.getLiteral());
            }
        });
        return words.toString()
                .toLowerCase(Locale.ROOT)
                .replaceAll("[^\\p{L}\\d -]", "")
                .replace(' ', '-');
    }

    /** Removes pictures, and replaces links by their texts. */
    private static final class WithoutReferences extends AbstractVisitor {
        @Override
        public void visit(Link link) {
            visitChildren(link);
            while (link.getFirstChild() != null) {
                link.insertBefore(link.getFirstChild());
            }
            link.unlink();
        }

        @Override
        public void visit(Image image) {
            image.unlink();
        }

        @Override
        public void visit(Paragraph paragraph) {
            visitChildren(paragraph);
            for (Node last = paragraph.getLastChild(); last instanceof SoftLineBreak; last = paragraph.getLastChild()) {
                last.unlink();
            }
            if (paragraph.getFirstChild() == null) {
                paragraph.unlink();
            }
        }
    }
}
