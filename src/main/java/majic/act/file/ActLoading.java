package majic.act.file;

import java.io.IOException;
import majic.act.ActException;
import majic.act.FailureText;
import majic.act.MajicAct;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * Makes an act from the contents of its file.
 *
 * @param label the file's name in errors
 * @param contents the file's checked contents
 */
record ActLoading(String label, ActContents contents) {
    MajicAct load(ClassLoader loader) {
        try {
            return checked(ActObjectInput.read(contents.data(), contents.own()::has, loader));
        } catch (NoClassDefFoundError e) {
            String missing = String.valueOf(e.getMessage()).replace('/', '.');
            throw refused("uses the class " + missing + ", which is neither in it nor in this MAJIC", e);
        } catch (ExceptionInInitializerError e) {
            throw refused("failed in its own code when it was loaded: " + FailureText.named(cause(e)), e);
        } catch (LinkageError e) {
            throw refused("has a class that this Java cannot use: " + e.getMessage(), e);
        } catch (IOException e) {
            throw refused(String.valueOf(e.getMessage()), e);
        } catch (ActException e) {
            throw e;
        } catch (RuntimeException | Error e) {
            throw refused("failed in its own code when it was loaded: " + FailureText.named(e), e);
        }
    }

    private MajicAct checked(@Nullable Object loaded) {
        if (loaded instanceof MajicAct act
                && act.getClass().getName().equals(contents.manifest().actClass())) {
            return act;
        }
        throw new ActException(label + " says that it is a "
                + contents.manifest().actClass() + ", but holds "
                + (loaded == null ? "nothing" : loaded.getClass().getName()));
    }

    private static Throwable cause(ExceptionInInitializerError failed) {
        Throwable cause = failed.getCause();
        return cause == null ? failed : cause;
    }

    private ActException refused(String why, Throwable cause) {
        String version = contents.manifest().majicVersion();
        String made = version.isEmpty() ? "" : " (it was made with MAJIC " + version + ")";
        return new ActException(VisibleText.of(label + " " + why + made), cause);
    }
}
