package majic.gui.help;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.stream.Stream;
import majic.text.Texts;

/**
 * Pages of the documents, in sections that can be searched. The build makes their HTML.
 *
 * @param sections in the order of the pages
 */
record GuidePage(List<Section> sections) {
    private static final Texts TEXTS = Texts.of(GuidePage.class);
    private static final String HEADING_OF_SECTION = "(?=<h[12][ >])";
    private static final String TAG = "<[^>]*>";

    /**
     * A part of a page below one heading of the first or second level.
     *
     * @param words its text without tags, for searching
     * @param html the same for display, with its heading
     */
    record Section(String words, String html) {
        static Section of(String html) {
            String words = html.replaceAll(TAG, "")
                    .replace("&lt;", "<")
                    .replace("&gt;", ">")
                    .replace("&quot;", "\"")
                    .replace("&amp;", "&");
            return new Section(words, html);
        }
    }

    /** Reads pages that are part of the program, without {@code .html}; may block. */
    static GuidePage read(List<String> names) {
        return new GuidePage(names.stream()
                .flatMap(name -> Stream.of(htmlOf(name).split(HEADING_OF_SECTION)))
                .map(Section::of)
                .toList());
    }

    private static String htmlOf(String name) {
        try (InputStream in = GuidePage.class.getResourceAsStream(name + ".html")) {
            return new String(Objects.requireNonNull(in, name).readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns the HTML of each section that contains a text, whatever its case; of all for an empty text. */
    List<String> html(String wanted) {
        String lower = wanted.toLowerCase(Locale.ROOT);
        List<String> found = sections.stream()
                .filter(section -> section.words().toLowerCase(Locale.ROOT).contains(lower))
                .map(Section::html)
                .toList();
        return found.isEmpty() ? List.of("<p>" + TEXTS.get("guide.nothing") + "</p>") : found;
    }
}
