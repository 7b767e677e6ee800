package majic.act.file;

import java.io.IOException;
import java.io.InvalidClassException;
import majic.act.ActException;
import majic.act.Blame;
import majic.act.MajicAct;
import majic.act.Printable;
import org.jspecify.annotations.Nullable;

/**
 * Makes an act from the contents of its file.
 *
 * @param label the file's name in errors
 * @param contents the file's checked contents
 */
record ActLoading(String label, ActContents contents) {
    MajicAct load(ClassLoader loader) {
        ActFilter filter = new ActFilter(contents.family()::has);
        try (ActObjectInput in = new ActObjectInput(contents.data(), filter, loader)) {
            return checked(in.readObject());
        } catch (InvalidClassException e) {
            throw refused(
                    e.classname == null
                            ? "holds what no act may hold"
                            : "was saved with another version of the class " + e.classname,
                    e);
        } catch (ClassNotFoundException | NoClassDefFoundError e) {
            throw refused("uses the class " + dotted(e) + ", which is neither in it nor in this MAJIC", e);
        } catch (ExceptionInInitializerError e) {
            throw refused("failed in its own code when it was loaded: " + Blame.named(cause(e)), e);
        } catch (LinkageError e) {
            throw refused("has a class that this Java cannot use: " + e.getMessage(), e);
        } catch (IOException e) {
            throw refused("is damaged: " + e.getMessage(), e);
        } catch (ActException e) {
            throw e;
        } catch (RuntimeException | Error e) {
            throw refused("failed in its own code when it was loaded: " + Blame.named(e), e);
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

    private static String dotted(Throwable missing) {
        return String.valueOf(missing.getMessage()).replace('/', '.');
    }

    private ActException refused(String why, Throwable cause) {
        String version = contents.manifest().majicVersion();
        String made = version.isEmpty() ? "" : " (it was made with MAJIC " + version + ")";
        return new ActException(Printable.of(label + " " + why + made), cause);
    }
}
