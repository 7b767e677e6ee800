package majic.act;

/**
 * The author's description of an act. Surrounding blanks and line ends are removed.
 *
 * @param name the act's name, as in {@code act NAME}
 * @param version the author's version number; may be empty
 * @param author the author's name; may be empty
 * @param description one or two sentences; may be empty
 */
public record ActDetails(String name, String version, String author, String description) {
    /** Turns each text into one line. */
    public ActDetails {
        name = Printable.line(name);
        version = Printable.line(version);
        author = Printable.line(author);
        description = Printable.line(description);
    }

    /**
     * Returns details that hold only a name.
     *
     * @param name the act's name
     * @return details with everything else empty
     */
    public static ActDetails named(String name) {
        return new ActDetails(name, "", "", "");
    }
}
