package majic.act.file;

import static java.io.ObjectStreamConstants.SC_BLOCK_DATA;
import static java.io.ObjectStreamConstants.SC_ENUM;
import static java.io.ObjectStreamConstants.SC_EXTERNALIZABLE;
import static java.io.ObjectStreamConstants.SC_SERIALIZABLE;
import static java.io.ObjectStreamConstants.SC_WRITE_METHOD;

import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/**
 * A class as an object stream describes it.
 *
 * @param name its name, with dots; of arrays as {@link Class#getName()} gives it
 * @param flags what follows of its objects
 * @param fieldTypes the type of each field, one letter each, as in descriptors
 * @param parent the class above it, if that is saved too
 */
record SerialClass(
        String name, int flags, String fieldTypes, @Nullable SerialClass parent) {
    /** This class and those above it, the topmost first: the order of their data. */
    Deque<SerialClass> lineage() {
        Deque<SerialClass> classes = new ArrayDeque<>();
        for (SerialClass one = this; one != null; one = one.parent) {
            classes.push(one);
        }
        return classes;
    }

    boolean hasFields() {
        return (flags & SC_SERIALIZABLE) != 0;
    }

    /** Whether the class has written more than its fields. */
    boolean hasMore() {
        return (flags & SC_WRITE_METHOD) != 0 || isExternal();
    }

    boolean isExternal() {
        return (flags & SC_EXTERNALIZABLE) != 0;
    }

    /** Whether its end can be found without knowing the class. */
    boolean isReadable() {
        return !isExternal() || (flags & SC_BLOCK_DATA) != 0;
    }

    boolean isEnum() {
        return (flags & SC_ENUM) != 0;
    }
}
