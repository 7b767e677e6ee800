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
import majic.text.IoReason;
import majic.text.Suggestion;

/**
 * Where behaviours are found by name: those that come with MAJIC, those in the user's own folder, and any file.
 *
 * @param folder the user's own; need not exist
 * @param trust which code the user has agreed to
 */
public record Acts(Path folder, ActTrust trust) {
    /** How files with behaviours end. */
    public static final String ENDING = ".act";

    /** How files with behaviours in MAJIC Script end. */
    public static final String SCRIPT_ENDING = ".majic";

    private static final String INDEX = "/acts/index";

    /**
     * Whether a name is that of a file, and not one that a behaviour goes by.
     *
     * @param name as a line names a behaviour
     * @return true if it ends in {@value #ENDING} or {@value #SCRIPT_ENDING}, whatever the case
     */
    public static boolean isFile(String name) {
        return endsIn(name, ENDING) || endsIn(name, SCRIPT_ENDING);
    }

    /**
     * Whether a file holds a behaviour in MAJIC Script.
     *
     * @param file its path or name
     * @return true if it ends in {@value #SCRIPT_ENDING}, whatever the case
     */
    public static boolean isScript(String file) {
        return endsIn(file, SCRIPT_ENDING);
    }

    private static boolean endsIn(String name, String ending) {
        return name.regionMatches(true, name.length() - ending.length(), ending, 0, ending.length());
    }

    /**
     * Finds the file of a behaviour. Names ignore case. A file in the user's folder goes before a behaviour of the same
     * name that comes with MAJIC.
     *
     * @param name a name without ending, or the path of a file; a file that is not there is looked for in the user's folder
     * @return the file, which for a path need not exist; empty for a behaviour that comes with MAJIC
     * @throws BotException if there is none of that name, or the user's folder has several; the message names what there is
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

    /** An act's file goes before a script, which it may have been made of. */
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
     * Whether a name means a file of the user's although a behaviour of that name comes with MAJIC.
     *
     * @param name without ending
     * @return true if the user's replaces it
     */
    public boolean replacesShipped(String name) {
        return shippedAs(name).isPresent()
                && own().stream().anyMatch(file -> stem(file).equalsIgnoreCase(name));
    }

    private static Optional<String> shippedAs(String name) {
        return shipped().stream().filter(name::equalsIgnoreCase).findFirst();
    }

    /**
     * Finds a behaviour and reads what it says of itself.
     *
     * @param name as for {@link #locate}
     * @return the act; nothing of its code is loaded
     * @throws BotException if there is none of that name, it is no act, or it is a script
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
        return new BotException("there is no behaviour " + name + Suggestion.didYouMean(name, names())
                + "; \"acts\" lists those there are, and a file's name ends in " + ENDING
                + " or " + SCRIPT_ENDING);
    }

    /**
     * The behaviours that need no path.
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

    /** The names of the files in the user's folder. */
    private List<String> own() {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(Acts::isFile)
                    .toList();
        } catch (IOException e) {
            throw new BotException(folder + ": cannot be read (" + IoReason.of(e) + ")", e);
        }
    }

    /** The build writes down which acts it made. */
    private static List<String> shipped() {
        try (InputStream in = Acts.class.getResourceAsStream(INDEX)) {
            if (in == null) {
                return List.of();
            }
            return new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))
                    .lines()
                    .filter(line -> !line.isBlank())
                    .toList();
        } catch (IOException e) {
            throw new BotException("MAJIC's own behaviours cannot be read (" + IoReason.of(e) + ")", e);
        }
    }
}
