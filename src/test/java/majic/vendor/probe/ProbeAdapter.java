package majic.vendor.probe;

import java.util.function.Supplier;
import liburbi.UClient;
import liburbi.call.URBIEvent;

/** Uses two classes of a library, as an adapter does: one in its own code, one in a class nested in it. */
public final class ProbeAdapter implements Supplier<String> {
    @Override
    public String get() {
        return new Nested().text() + " by " + UClient.class.getClassLoader().getName();
    }

    private static final class Nested {
        String text() {
            return new URBIEvent().getCmd();
        }
    }
}
