package majic.act;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.bot.IoReason;
import majic.bot.Suggestion;

/**
 * Where behaviours are found by name: those that come with MAJIC, those in the user's own folder, and any file.
 *
 * @param folder the user's own; need not exist
 * @param trust which code the user has agreed to
 */
public record Acts(Path folder, ActTrust trust) {
    /** How files with behaviours end. */
    public static final String ENDING = ".act";

    private static final String INDEX = "/acts/index";

    /**
     * Finds a behaviour and reads what it says of itself.
     *
     * @param name of one that comes with MAJIC, or lies in the user's folder; or a path that ends in {@value #ENDING}
     * @return the act; nothing of its code is loaded
     * @throws BotException if there is none of that name, or it is no act; the message names what there is
     */
    public ActFile find(String name) {
        if (name.endsWith(ENDING)) {
            return ActFile.read(Path.of(name));
        }
        Path own = folder.resolve(name + ENDING);
        if (name.matches("[\\w-]+") && Files.exists(own)) {
            return ActFile.read(own);
        }
        String shipped =
                shipped().stream().filter(name::equalsIgnoreCase).findFirst().orElseThrow(() -> unknown(name));
        return ActFile.shipped(shipped);
    }

    private BotException unknown(String name) {
        return new BotException("there is no behaviour " + name + Suggestion.didYouMean(name, names())
                + "; \"acts\" lists those there are, and a file's name ends in " + ENDING);
    }

    /**
     * The behaviours that need no path.
     *
     * @return their names, sorted
     */
    public List<String> names() {
        TreeSet<String> names = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
        names.addAll(shipped());
        names.addAll(own());
        return List.copyOf(names);
    }

    private List<String> own() {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(file -> file.endsWith(ENDING))
                    .map(file -> file.substring(0, file.length() - ENDING.length()))
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
