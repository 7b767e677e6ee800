package majic.act.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.SortedSet;
import java.util.TreeSet;
import majic.act.ActArgument;
import majic.act.ActDetails;
import majic.act.ActException;
import majic.act.MajicAct;
import majic.act.Role;
import majic.file.RegularFile;
import majic.text.IoReason;
import majic.text.VisibleText;

/**
 * A behaviour in a file: a jar with the act's classes, the saved act and a manifest, or the object stream of an act
 * whose class MAJIC has. Reading it checks it and loads none of its code; {@link #load} loads the code, once the user
 * has agreed. Immutable; the act is loaded from the bytes that were read, even if the file has changed since.
 */
public final class ActFile {
    public static final ClassLoader MAJIC = Objects.requireNonNull(MajicAct.class.getClassLoader());

    private final String label;
    private final String sha256;
    private final boolean shipped;
    private final ActContents contents;
    private final List<Role> roles;
    private final List<ActArgument> arguments;

    private ActFile(String label, byte[] bytes, boolean shipped) {
        this.label = label;
        this.shipped = shipped;
        this.sha256 = Signatures.sha256(bytes);
        try {
            this.contents = ActContents.of(bytes, MAJIC);
        } catch (IOException e) {
            throw new ActException(VisibleText.of(label + " " + e.getMessage()), e);
        } catch (RuntimeException e) {
            // The JDK's readers of manifests and certificates do not promise more than that.
            throw new ActException(VisibleText.of(label + " is damaged: its contents make no sense"), e);
        }
        if (carriesCode()) {
            this.roles = contents.manifest().roles();
            this.arguments = contents.manifest().arguments();
        } else {
            MajicAct act = loadAgreed();
            this.roles = act.roles();
            this.arguments = act.arguments();
        }
    }

    /**
     * Reads a file, to show its contents. None of its code is loaded.
     *
     * @param file the file
     * @return the checked file
     * @throws ActException if it cannot be read, or is not an act that this MAJIC can load
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
     * Reads a file that is in memory.
     *
     * @param label the file's name in errors
     * @param bytes the whole file
     * @return the checked file
     * @throws ActException if it is not an act that this MAJIC can load
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
     * Makes the act. Every call makes a new one, from classes of its own, which are unloaded with it. From this call on
     * the act's code runs: static initialisers, and code that runs when the act is read.
     *
     * @param trust the user's consents
     * @return an act that has no robot yet
     * @throws ActException if the user has not agreed to its code, or if it cannot be linked or read
     */
    public MajicAct load(ActTrust trust) {
        if (!trust.isTrusted(this)) {
            throw new ActException(label + " contains code that has no consent yet");
        }
        return loadAgreed();
    }

    /**
     * Returns the file's name in errors.
     *
     * @return the file's name without its folder
     */
    public String label() {
        return label;
    }

    /**
     * Returns the author's description of the act.
     *
     * @return name, version, author, description; none of them is verified
     */
    public ActDetails details() {
        return contents.manifest().details();
    }

    /**
     * Returns the name of the act's class.
     *
     * @return the name with dots
     */
    public String actClass() {
        return contents.manifest().actClass();
    }

    /**
     * Returns the version of the MAJIC that made the file.
     *
     * @return for instance {@code 0.1.0}; empty if unknown
     */
    public String majicVersion() {
        return contents.manifest().majicVersion();
    }

    /**
     * Returns the robots that the act needs: as the file states, or without code in it as the act itself does.
     *
     * @return at least one, the first being the one the act is loaded onto
     */
    public List<Role> roles() {
        return roles;
    }

    /**
     * Returns the arguments that the act takes: as the file states, or without code in it as the act itself does.
     *
     * @return possibly none
     */
    public List<ActArgument> arguments() {
        return arguments;
    }

    /**
     * Returns the signers of the file.
     *
     * @return the signers whose signatures match the whole file; empty if it is not signed
     */
    public List<Signer> signers() {
        return contents.signers();
    }

    /**
     * Returns the SHA-256 hash of the whole file.
     *
     * @return 64 hexadecimal digits
     */
    public String sha256() {
        return sha256;
    }

    /**
     * Returns whether the act came with MAJIC.
     *
     * @return true if so; it is then trusted
     */
    public boolean isShipped() {
        return shipped;
    }

    /**
     * Returns whether loading the file runs code that is not MAJIC's.
     *
     * @return false for saved objects of MAJIC's own classes, such as scripts
     */
    public boolean carriesCode() {
        return !contents.classes().isEmpty();
    }

    /**
     * Returns the classes in the file.
     *
     * @return their names with dots, sorted
     */
    public List<String> classes() {
        return List.copyOf(contents.classes().keySet());
    }

    /**
     * Returns the files beside the classes, for these to read.
     *
     * @return their paths in the jar, sorted
     */
    public List<String> resources() {
        return contents.entries().keySet().stream()
                .filter(path -> !path.startsWith("META-INF/"))
                .filter(path -> !path.equals(ActContents.DATA))
                .filter(path -> ClassNames.classAt(path).isEmpty())
                .sorted()
                .toList();
    }

    /**
     * Returns the packages that the classes use. Classes found by name at run time are not included.
     *
     * @return their names, sorted, without the packages of the file itself
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
     * Returns a description of the file, to show before the user agrees to it.
     *
     * @return one line for each item, without line ends
     */
    public List<String> describe() {
        return ActDescription.of(this);
    }

    /** Makes the act of a file whose code is trusted. */
    public MajicAct loadAgreed() {
        ClassLoader loader = carriesCode() ? new ActClassLoader(label, contents.entries(), MAJIC) : MAJIC;
        return new ActLoading(label, contents).load(loader);
    }
}
