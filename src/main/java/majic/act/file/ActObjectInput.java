package majic.act.file;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InvalidClassException;
import java.io.ObjectInputStream;
import java.io.ObjectStreamClass;

/** Reads an act; a class that the filter does not admit is not searched for. */
public final class ActObjectInput extends ObjectInputStream {
    private final ActFilter filter;
    private final ClassLoader loader;

    public ActObjectInput(byte[] stream, ActFilter filter, ClassLoader loader) throws IOException {
        super(new ByteArrayInputStream(stream));
        this.filter = filter;
        this.loader = loader;
        setObjectInputFilter(filter);
    }

    @Override
    protected Class<?> resolveClass(ObjectStreamClass described) throws IOException, ClassNotFoundException {
        if (!filter.admits(described.getName())) {
            throw new InvalidClassException(described.getName(), "not admitted");
        }
        return Class.forName(described.getName(), false, loader);
    }

    @Override
    protected Class<?> resolveProxyClass(String[] interfaces) throws IOException {
        throw new InvalidClassException("a dynamic proxy is not admitted");
    }
}
