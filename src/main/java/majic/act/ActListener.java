package majic.act;

/** Receives the events of a running act, on the act's thread. */
interface ActListener {
    /**
     * Receives a note on what the act is doing.
     *
     * @param words the act's note
     */
    void said(String words);

    /** Receives the end of the act, after its clean-up; the act can no longer use a robot. */
    void ended();
}
