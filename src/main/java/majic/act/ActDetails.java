package majic.act;

/**
 * What its author says of an act. Blanks around and line ends within are taken out.
 *
 * @param name what it is called, as in {@code act NAME}
 * @param version the author's own; may be empty
 * @param author who made it; may be empty
 * @param description one or two sentences; may be empty
 */
public record ActDetails(String name, String version, String author, String description) {
    /** Makes one line of each. */
    public ActDetails {
        name = Printable.line(name);
        version = Printable.line(version);
        author = Printable.line(author);
        description = Printable.line(description);
    }

    /**
     * Details of an act of which nothing else is known.
     *
     * @param name what it is called
     * @return details with everything else empty
     */
    public static ActDetails named(String name) {
        return new ActDetails(name, "", "", "");
    }
}
