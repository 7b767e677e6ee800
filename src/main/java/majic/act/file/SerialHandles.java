package majic.act.file;

import static java.io.ObjectStreamConstants.baseWireHandle;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Maps the references in an object stream to their values, and refuses those that no act may use. */
final class SerialHandles {
    private final List<Node> nodes = new ArrayList<>();

    /** Holds a value that a later reference may refer to. */
    static final class Node {
        private final boolean shareable;
        private boolean open = true;
        private @Nullable SerialClass described;

        private Node(boolean shareable) {
            this.shareable = shareable;
        }

        /** Marks the value as completely read. */
        void close() {
            open = false;
        }

        void close(SerialClass type) {
            described = type;
            open = false;
        }
    }

    /**
     * Assigns the next handle to a value in the stream.
     *
     * @param shareable whether references to it are permitted after it is completely read
     */
    Node add(boolean shareable) throws Unfit {
        if (nodes.size() == PlainValues.MAX_OBJECTS) {
            throw new Unfit("holds more than " + PlainValues.MAX_OBJECTS + " objects");
        }
        Node node = new Node(shareable);
        nodes.add(node);
        return node;
    }

    /** Resolves a reference to a value. */
    void checkValue(int handle) throws Unfit {
        Node node = node(handle);
        if (node.open) {
            throw new Unfit("holds data that holds itself, such as an object of an inner class that is not static");
        }
        if (!node.shareable) {
            throw new Unfit("holds the same collection in two places");
        }
    }

    /** Resolves a reference to a class. */
    SerialClass classAt(int handle) throws Unfit {
        SerialClass known = node(handle).described;
        if (known == null) {
            throw SerialScan.damaged();
        }
        return known;
    }

    private Node node(int handle) throws Unfit {
        int index = handle - baseWireHandle;
        if (index < 0 || index >= nodes.size()) {
            throw SerialScan.damaged();
        }
        return nodes.get(index);
    }
}
