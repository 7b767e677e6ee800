package majic.act;

/** Hears of an act while it runs, on the thread of the act. */
interface Audience {
    /**
     * It says what it is doing.
     *
     * @param words its own
     */
    void said(String words);

    /** It has ended, its ending included; it has no robot any more. */
    void ended();
}
