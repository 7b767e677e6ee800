package majic.gui.help;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.stream.Collectors;
import majic.text.Texts;

/**
 * A page of the documents, in sections that can be searched.
 *
 * @param sections in the order of the page
 */
record GuidePage(List<Section> sections) {
    private static final Texts TEXTS = Texts.of(GuidePage.class);
    /**
     * A part of a page below one heading.
     *
     * @param words its text as in the document, for searching
     * @param html the same for display, with its heading
     */
    record Section(String words, String html) {}

    /** Reads a page that is part of the program; may block. */
    static GuidePage read(String name) {
        try (InputStream in = GuidePage.class.getResourceAsStream(name + ".md");
                BufferedReader lines = new BufferedReader(
                        new InputStreamReader(Objects.requireNonNull(in, name), StandardCharsets.UTF_8))) {
            return of(lines.lines().toList());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Splits a page at its headings of the first and second level. */
    static GuidePage of(List<String> lines) {
        List<Section> sections = new ArrayList<>();
        List<String> open = new ArrayList<>();
        for (String line : lines) {
            if (line.startsWith("# ") || line.startsWith("## ")) {
                close(open, sections);
            }
            open.add(line);
        }
        close(open, sections);
        return new GuidePage(sections);
    }

    private static void close(List<String> open, List<Section> sections) {
        if (!open.isEmpty()) {
            sections.add(new Section(String.join("\n", open), new MarkdownHtml().convert(open)));
            open.clear();
        }
    }

    /** Returns the HTML of the sections that contain a text, whatever its case; of all for an empty text. */
    String html(String wanted) {
        String lower = wanted.toLowerCase(Locale.ROOT);
        String found = sections.stream()
                .filter(section -> section.words().toLowerCase(Locale.ROOT).contains(lower))
                .map(Section::html)
                .collect(Collectors.joining());
        return found.isEmpty() ? "<p>" + TEXTS.get("guide.nothing") + "</p>" : found;
    }
}
