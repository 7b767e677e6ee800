package majic.gui.help;

import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;

/**
 * Converts Markdown to HTML as Swing displays it, as far as the documents of MAJIC use Markdown: headings, paragraphs,
 * lists of one level, tables, blocks of code, and emphasis. Pictures and the targets of links are left out.
 */
final class MarkdownHtml {
    private static final Pattern ITEM = Pattern.compile("(- |\\d+\\. ).*");
    private static final String FENCE = "```";

    private final StringBuilder html = new StringBuilder();
    private final StringBuilder text = new StringBuilder();
    private String block = "";
    private boolean code;

    String convert(List<String> lines) {
        lines.forEach(this::line);
        endText();
        endBlock("");
        return html.toString();
    }

    private void line(String line) {
        String words = line.strip();
        if (words.startsWith(FENCE)) {
            endText();
            endBlock("");
            html.append(code ? "</pre>" : "<pre>");
            code = !code;
        } else if (code) {
            html.append(escaped(line)).append('\n');
        } else if (words.startsWith("|")) {
            tableRow(words);
        } else if (words.isEmpty() || words.startsWith("![")) {
            endText();
        } else {
            textLine(line, words);
        }
    }

    private void textLine(String line, String words) {
        if (line.startsWith("#")) {
            endText();
            endBlock("");
            int level = line.indexOf(' ');
            String heading = line.substring(level + 1);
            html.append("<h" + level + " id=" + id(heading) + ">" + inline(heading) + "</h" + level + ">");
            return;
        }
        if (ITEM.matcher(line).matches()) {
            endText();
            beginBlock(line.startsWith("-") ? "ul" : "ol");
            text.append(words.substring(words.indexOf(' ') + 1));
            return;
        }
        if (text.isEmpty() && !line.startsWith(" ")) {
            endBlock("");
        }
        text.append(text.isEmpty() ? "" : " ").append(words);
    }

    private void tableRow(String words) {
        endText();
        beginBlock("table");
        if (words.replaceAll("[|: -]", "").isEmpty()) {
            return;
        }
        html.append("<tr>");
        for (String cell : words.substring(1).split("(?<!\\\\)\\|")) {
            html.append("<td valign=top>")
                    .append(inline(cell.strip().replace("\\|", "|")))
                    .append("</td>");
        }
        html.append("</tr>");
    }

    /** Returns a heading as links name it: lower case, without punctuation, words joined by {@code -}. */
    static String id(String heading) {
        return heading.toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\d -]", "").replace(' ', '-');
    }

    /** Ends the paragraph or the item. */
    private void endText() {
        if (!text.isEmpty()) {
            String tag = block.equals("ul") || block.equals("ol") ? "li" : "p";
            html.append("<" + tag + ">" + inline(text.toString()) + "</" + tag + ">");
            text.setLength(0);
        }
    }

    private void beginBlock(String tag) {
        if (!block.equals(tag)) {
            endBlock(tag);
            html.append("<" + tag + (tag.equals("table") ? " cellpadding=4" : "") + ">");
        }
    }

    /** Ends the list or table, if there is one. */
    private void endBlock(String next) {
        if (!block.isEmpty()) {
            html.append("</" + block + ">");
        }
        block = next;
    }

    /** Converts emphasis, except in code, where asterisks are plain characters. */
    private static String inline(String words) {
        StringBuilder all = new StringBuilder();
        String[] parts = words.split("`", -1);
        for (int index = 0; index < parts.length; index++) {
            String part = escaped(parts[index]);
            all.append(index % 2 == 1 ? "<code>" + part + "</code>" : emphasis(part));
        }
        return all.toString();
    }

    private static String emphasis(String words) {
        return words.replaceAll("!?\\[([^\\]]*)\\]\\([^)]*\\)", "$1")
                .replaceAll("\\*\\*([^*]+)\\*\\*", "<b>$1</b>")
                .replaceAll("\\*([^*]+)\\*", "<i>$1</i>");
    }

    /** Returns the text with all characters escaped that HTML would interpret as a tag. */
    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
