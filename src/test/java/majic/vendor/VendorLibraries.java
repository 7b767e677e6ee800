package majic.vendor;

import java.lang.reflect.Field;

/** Lets tests of different installations run in one process. */
public final class VendorLibraries {
    private VendorLibraries() {}

    /** Forgets which installation of a library is loaded. */
    public static void forget(VendorLibrary library) {
        try {
            Field loader = VendorLibrary.class.getDeclaredField("loader");
            loader.setAccessible(true);
            loader.set(library, null);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(e);
        }
    }
}
