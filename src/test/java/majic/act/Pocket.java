package majic.act;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.Serializable;

/** An act that MAJIC has the class of, and that has anything in its pocket. */
class Pocket extends MajicAct {
    private static final long serialVersionUID = 1;

    /** How a pocket is closed: an enum of the act's own. */
    enum Button {
        OPEN,
        SHUT
    }

    final Serializable held;
    final Button button = Button.SHUT;

    Pocket(Serializable held) {
        this.held = held;
    }

    @Override
    protected void behave() {}

    static byte[] with(Serializable held) throws IOException {
        return stream(new Pocket(held));
    }

    static byte[] stream(Object saved) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(saved);
        }
        return bytes.toByteArray();
    }
}
