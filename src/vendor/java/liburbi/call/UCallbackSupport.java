package liburbi.call;

/** Signature: the listeners of a client by their tags; the client passes every message here. */
public class UCallbackSupport {
    public void notifyUCallbackListener(URBIEvent event) {
        throw new signatures.SignatureOnly();
    }
}
