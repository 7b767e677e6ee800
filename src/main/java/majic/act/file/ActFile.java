package majic.act.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.SortedSet;
import java.util.TreeSet;
import majic.act.ActDetails;
import majic.act.ActException;
import majic.act.MajicAct;
import majic.act.Printable;
import majic.act.RegularFile;
import majic.act.Role;
import majic.text.IoReason;

/**
 * A behaviour in a file: a jar with the act's classes, the saved act and a manifest, or the object stream of an act
 * that MAJIC has the class of. Reading one checks it and loads none of its code; {@link #load} does, once the user has
 * agreed. Immutable; what is loaded is what was read, whatever became of the file meanwhile.
 */
public final class ActFile {
    public static final ClassLoader MAJIC = Objects.requireNonNull(MajicAct.class.getClassLoader());

    private final String label;
    private final String sha256;
    private final boolean shipped;
    private final ActContents contents;

    private ActFile(String label, byte[] bytes, boolean shipped) {
        this.label = label;
        this.shipped = shipped;
        this.sha256 = Sha256.of(bytes);
        try {
            this.contents = ActContents.of(bytes, MAJIC);
        } catch (IOException e) {
            throw new ActException(Printable.of(label + " " + e.getMessage()), e);
        } catch (RuntimeException e) {
            // The JDK's readers of manifests and certificates do not promise more than that.
            throw new ActException(Printable.of(label + " is damaged: its contents make no sense"), e);
        }
    }

    /**
     * Reads a file, to show what it is. Nothing of its code is loaded.
     *
     * @param file the file
     * @return what it says of itself
     * @throws ActException if it cannot be read, or is no act that this MAJIC can load
     */
    public static ActFile read(Path file) {
        try {
            return of(String.valueOf(file.getFileName()), RegularFile.read(file, BoundedZip.MAX_FILE_BYTES + 1));
        } catch (NoSuchFileException e) {
            throw new ActException("there is no file " + file, e);
        } catch (IOException e) {
            throw new ActException("cannot read " + file + ": " + IoReason.of(e), e);
        }
    }

    /**
     * Takes a file that is in memory.
     *
     * @param label what to call it in errors
     * @param bytes the whole file
     * @return what it says of itself
     * @throws ActException if it is no act that this MAJIC can load
     */
    public static ActFile of(String label, byte[] bytes) {
        return new ActFile(label, bytes, false);
    }

    /**
     * Reads an act that comes with MAJIC, in {@code /acts} of its jar.
     *
     * @param name its name, without {@code .act}
     * @return the act; trusted
     * @throws ActException if MAJIC has none of this name
     */
    public static ActFile shipped(String name) {
        if (!name.matches("\\w+")) {
            throw new ActException("MAJIC has no act " + name);
        }
        try (InputStream in = MajicAct.class.getResourceAsStream("/acts/" + name + ".act")) {
            if (in == null) {
                throw new ActException("MAJIC has no act " + name);
            }
            return new ActFile(name, in.readAllBytes(), true);
        } catch (IOException e) {
            throw new ActException("cannot read MAJIC's own act " + name + ": " + IoReason.of(e), e);
        }
    }

    /**
     * Makes the act. Every call makes a new one, from classes of its own, which go when it goes. The act's code runs
     * from here on: static initialisers, and whatever it does when it is read.
     *
     * @param trust what the user has agreed to
     * @return an act that has no robot yet
     * @throws ActException if the user has not agreed to its code, or if it cannot be linked or read
     */
    public MajicAct load(ActTrust trust) {
        if (!trust.isTrusted(this)) {
            throw new ActException(label + " brings code of its own, which nobody has agreed to run");
        }
        return loadAgreed();
    }

    /**
     * What it is called in errors.
     *
     * @return the file's name without its folder
     */
    public String label() {
        return label;
    }

    /**
     * What its author says of it.
     *
     * @return name, version, author, description; nothing vouches for them
     */
    public ActDetails details() {
        return contents.manifest().details();
    }

    /**
     * The act's class.
     *
     * @return its name with dots
     */
    public String actClass() {
        return contents.manifest().actClass();
    }

    /**
     * Which MAJIC made the file.
     *
     * @return for instance {@code 0.1.0}; empty if unknown
     */
    public String majicVersion() {
        return contents.manifest().majicVersion();
    }

    /**
     * The robots the act asks for. A mere object stream does not say; the loaded act then knows better.
     *
     * @return at least one, the first being the one the act is loaded onto
     */
    public List<Role> roles() {
        return contents.manifest().roles();
    }

    /**
     * Who signed it.
     *
     * @return those whose signatures fit all of the file; empty if it is not signed
     */
    public List<Signer> signers() {
        return contents.signers();
    }

    /**
     * The hash of the whole file.
     *
     * @return 64 hexadecimal digits
     */
    public String sha256() {
        return sha256;
    }

    /**
     * Whether it came with MAJIC.
     *
     * @return true if so, and then it is trusted
     */
    public boolean isShipped() {
        return shipped;
    }

    /**
     * Whether loading it runs code that is not MAJIC's.
     *
     * @return false for saved objects of MAJIC's own classes, such as scripts
     */
    public boolean carriesCode() {
        return !contents.classes().isEmpty();
    }

    /**
     * The classes it brings.
     *
     * @return their names with dots, sorted
     */
    public List<String> classes() {
        return List.copyOf(contents.classes().keySet());
    }

    /**
     * The files it brings beside classes, for these to read.
     *
     * @return their paths in it, sorted
     */
    public List<String> resources() {
        return contents.entries().keySet().stream()
                .filter(path -> !path.startsWith("META-INF/"))
                .filter(path -> !path.equals(ActContents.DATA))
                .filter(path -> ActNames.classAt(path).isEmpty())
                .sorted()
                .toList();
    }

    /**
     * The packages its classes use. What they find by name at run time is not among them.
     *
     * @return their names, sorted, but for the file's own
     */
    public List<String> packages() {
        SortedSet<String> packages = new TreeSet<>();
        contents.classes().values().stream()
                .flatMap(code -> code.uses().stream())
                .filter(used -> !contents.classes().containsKey(used))
                .map(ClassFile::packageOf)
                .forEach(packages::add);
        return List.copyOf(packages);
    }

    /**
     * All of this for people, one line each, to show before they agree.
     *
     * @return lines without line ends
     */
    public List<String> describe() {
        return ActSheet.of(this);
    }

    /** Makes the act of a file whose code may run. */
    public MajicAct loadAgreed() {
        ClassLoader loader = carriesCode() ? new ActClassLoader(label, contents.entries(), MAJIC) : MAJIC;
        return new ActLoading(label, contents).load(loader);
    }
}
