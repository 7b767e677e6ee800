package majic.act.file;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.text.Advice;
import majic.text.IoReason;
import majic.text.Suggestion;

/**
 * Finds behaviours by name: those that come with MAJIC, those in the user's folder, and any file.
 *
 * @param folder the user's folder; need not exist
 * @param trust the user's consents
 */
public record ActCatalog(Path folder, ActTrust trust) {
    /** The file name extension of acts. */
    public static final String ENDING = ".act";

    /** The file name extension of behaviours in MAJIC Script. */
    public static final String SCRIPT_ENDING = ".majic";

    private static final String INDEX = "/acts/index";

    /**
     * Returns whether a name is that of a file, not of a behaviour.
     *
     * @param name a behaviour's name or file, as in a command
     * @return true if it ends in {@value #ENDING} or {@value #SCRIPT_ENDING}, in upper or lower case
     */
    public static boolean isFile(String name) {
        return endsIn(name, ENDING) || endsIn(name, SCRIPT_ENDING);
    }

    /**
     * Returns whether a file is a behaviour in MAJIC Script.
     *
     * @param file its path or name
     * @return true if it ends in {@value #SCRIPT_ENDING}, in upper or lower case
     */
    public static boolean isScript(String file) {
        return endsIn(file, SCRIPT_ENDING);
    }

    private static boolean endsIn(String name, String ending) {
        return name.regionMatches(true, name.length() - ending.length(), ending, 0, ending.length());
    }

    /**
     * Finds the file of a behaviour. Names ignore case. A file in the user's folder takes precedence over a behaviour
     * of the same name that comes with MAJIC.
     *
     * @param name a name without extension, or the path of a file; if there is no such file, the user's folder is
     *     searched
     * @return the file, which for a path need not exist; empty for a behaviour that comes with MAJIC
     * @throws BotException if there is none of that name, or the user's folder has several; the message lists the
     *     available names
     */
    public Optional<Path> locate(String name) {
        if (isFile(name)) {
            Path given = path(name);
            boolean isOwn = given.getNameCount() == 1 && !Files.exists(given) && Files.exists(folder.resolve(given));
            return Optional.of(isOwn ? folder.resolve(given) : given);
        }
        List<String> files = ownNamed(name);
        if (files.size() > 1) {
            throw new BotException(name + ": there are several of that name, " + String.join(" and ", files) + " in "
                    + folder + "; rename one");
        }
        if (files.isEmpty() && shippedAs(name).isEmpty()) {
            throw unknown(name);
        }
        return files.stream().findFirst().map(folder::resolve);
    }

    /** Returns the user's files of a name. Acts take precedence over scripts, from which they may have been made. */
    private List<String> ownNamed(String name) {
        List<String> files = own().stream()
                .filter(file -> stem(file).equalsIgnoreCase(name))
                .sorted()
                .toList();
        List<String> acts = files.stream().filter(file -> !isScript(file)).toList();
        return acts.isEmpty() ? files : acts;
    }

    private static Path path(String name) {
        try {
            return Path.of(name);
        } catch (InvalidPathException e) {
            throw new BotException(name + ": no file can have that name", e);
        }
    }

    /**
     * Returns whether a file of the user replaces a behaviour of the same name that comes with MAJIC.
     *
     * @param name the name without extension
     * @return true if the user's file replaces it
     */
    public boolean replacesShipped(String name) {
        return shippedAs(name).isPresent()
                && own().stream().anyMatch(file -> stem(file).equalsIgnoreCase(name));
    }

    private static Optional<String> shippedAs(String name) {
        return shipped().stream().filter(name::equalsIgnoreCase).findFirst();
    }

    /**
     * Records that the user agrees to the code of a file.
     *
     * @param file the file
     * @param name the name by which it was found, as for {@link #locate}
     * @throws BotException if the change could not be saved; it is then valid until the program ends
     */
    public void agree(ActFile file, String name) {
        trust.agree(
                file, locate(name).map(path -> path.toAbsolutePath().toString()).orElse(""));
    }

    /**
     * Finds a behaviour and reads its description.
     *
     * @param name as for {@link #locate}
     * @return the act; none of its code is loaded
     * @throws BotException if there is none of that name, it is not an act, or it is a script
     */
    public ActFile find(String name) {
        Optional<Path> file = locate(name);
        if (file.filter(path -> isScript(path.toString())).isPresent()) {
            throw new BotException(name + ": a script, which brings no code");
        }
        return file.map(ActFile::read)
                .orElseGet(() -> ActFile.shipped(shippedAs(name).orElseThrow()));
    }

    private BotException unknown(String name) {
        return new BotException(Advice.joined(
                "there is no act " + name + Suggestion.didYouMean(name, names()),
                "\"acts\" lists those there are, and a file's name ends in " + ENDING + " or " + SCRIPT_ENDING));
    }

    /**
     * Returns the behaviours that need no path.
     *
     * @return their names, sorted
     */
    public List<String> names() {
        TreeSet<String> names = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
        names.addAll(shipped());
        own().forEach(file -> names.add(stem(file)));
        return List.copyOf(names);
    }

    private static String stem(String file) {
        return file.substring(0, file.lastIndexOf('.'));
    }

    /** Returns the names of the files in the user's folder. */
    private List<String> own() {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(ActCatalog::isFile)
                    .toList();
        } catch (IOException e) {
            throw new BotException(folder + ": cannot be read (" + IoReason.of(e) + ")", e);
        }
    }

    /** Returns the acts that come with MAJIC, from the list that the build writes. */
    private static List<String> shipped() {
        try (InputStream in = ActCatalog.class.getResourceAsStream(INDEX)) {
            if (in == null) {
                return List.of();
            }
            return new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))
                    .lines()
                    .filter(line -> !line.isBlank())
                    .toList();
        } catch (IOException e) {
            throw new BotException("MAJIC's own acts cannot be read (" + IoReason.of(e) + ")", e);
        }
    }
}
