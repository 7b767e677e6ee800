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
 * Holds the description of a class in an object stream.
 *
 * @param name its name, with dots; for arrays as {@link Class#getName()} returns it
 * @param flags the stream's flags, which define the data of its objects
 * @param fieldTypes the type of each field, one letter each, as in descriptors
 * @param parent its superclass, if that is saved too
 */
record SerialClass(
        String name, int flags, String fieldTypes, @Nullable SerialClass parent) {
    /** Returns this class and its superclasses, the topmost first: the order of their data. */
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

    /** Returns whether the class has written data beside its fields. */
    boolean hasMore() {
        return (flags & SC_WRITE_METHOD) != 0 || isExternal();
    }

    boolean isExternal() {
        return (flags & SC_EXTERNALIZABLE) != 0;
    }

    /** Returns whether the end of its data can be found without loading the class. */
    boolean isReadable() {
        return !isExternal() || (flags & SC_BLOCK_DATA) != 0;
    }

    boolean isEnum() {
        return (flags & SC_ENUM) != 0;
    }
}
