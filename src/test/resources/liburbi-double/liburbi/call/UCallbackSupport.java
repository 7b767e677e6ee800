package liburbi.call;

import java.util.Hashtable;
import java.util.Map;

public class UCallbackSupport {
    private final Map<String, UCallbackListener> listeners = new Hashtable<>();

    public void addUCallbackListener(UCallbackListener listener, String tag) {
        listeners.put(tag, listener);
    }

    public void removeUCallbackListener(String tag) {
        listeners.remove(tag);
    }

    public void notifyUCallbackListener(URBIEvent event) {
        UCallbackListener listener = listeners.get(event.getTag());
        if (listener == null) {
            System.out.println("[" + event.getTimestamp() + ":" + event.getTag() + "] " + event.getCmd());
        } else {
            listener.actionPerformed(event);
        }
    }
}
