package liburbi.call;

/** Signature: receives the messages under a tag, on the reader thread. */
public interface UCallbackListener {
    void actionPerformed(URBIEvent event);
}
