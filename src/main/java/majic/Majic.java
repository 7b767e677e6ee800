package majic;

/** Starts MAJIC. */
public final class Majic {
    private Majic() {}

    /**
     * Starts the program.
     *
     * @param args the command line
     */
    public static void main(String[] args) {
        System.out.println("MAJIC");
    }
}
