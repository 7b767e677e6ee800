package liburbi.call;

public interface UCallbackListener {
    void actionPerformed(URBIEvent event);
}
