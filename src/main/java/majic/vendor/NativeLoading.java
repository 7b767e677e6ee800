package majic.vendor;

import java.nio.file.Path;
import java.util.function.Consumer;

/**
 * Loads a native library for the class loader that has defined this class. Each {@link VendorLoader} defines it anew,
 * because Java finds the native methods of a class only in libraries of that class's own loader.
 */
public final class NativeLoading implements Consumer<Path> {
    /** Made by {@link VendorLoader}. */
    public NativeLoading() {}

    @Override
    public void accept(Path file) {
        System.load(file.toString());
    }
}
