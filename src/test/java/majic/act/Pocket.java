package majic.act;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.Serializable;

/** An act whose class MAJIC has, with any object in a field. */
class Pocket extends MajicAct {
    private static final long serialVersionUID = 1;

    /** An enum that belongs to the act. */
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
