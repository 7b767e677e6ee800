package majic.cli;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.lang.model.SourceVersion;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.team.BotFactory;

/**
 * The files of a Maven project, whose sources are examples that the build tests. A project has its own name in place of
 * that of the example, and its classes are in a package of that name.
 */
final class ProjectTemplate {
    private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9]*");
    private static final String MAIN = "src/main/java/";
    private static final String TEST = "src/test/java/";

    private final String example;
    private final boolean isRobot;

    /** The files in the project, by their files in the folder of the template. */
    private final Map<String, String> files = new LinkedHashMap<>();

    private ProjectTemplate(String example, boolean isRobot) {
        this.example = example;
        this.isRobot = isRobot;
        with("pom.xml", "pom.xml");
        with("README.md", "README.md");
    }

    private ProjectTemplate with(String resource, String file) {
        files.put(resource, file);
        return this;
    }

    static ProjectTemplate robot() {
        return new ProjectTemplate("Cart", true)
                .with("Cart.java", MAIN + "cart/Cart.java")
                .with("majic.bot.BotType", "src/main/resources/META-INF/services/majic.bot.BotType")
                .with("CartPeer.java", TEST + "cart/CartPeer.java")
                .with("CartTest.java", TEST + "cart/CartTest.java");
    }

    static ProjectTemplate act() {
        return new ProjectTemplate("Pacer", false)
                .with("Pacer.java", MAIN + "pacer/Pacer.java")
                .with("PacerTest.java", TEST + "pacer/PacerTest.java");
    }

    /**
     * Writes a project.
     *
     * @param name of its main class; the first letter becomes a capital
     * @param folder does not exist yet, or is empty
     * @return the files, in the order in which they were written
     * @throws BotException if the name cannot be used or the folder is not empty; nothing was written
     */
    List<Path> write(String name, Path folder) throws IOException {
        checkName(name);
        Map<String, String> texts = new LinkedHashMap<>();
        for (Map.Entry<String, String> file : files.entrySet()) {
            texts.put(named(file.getValue(), name), named(text(file.getKey()), name));
        }
        checkClassName(name, texts);
        checkFolder(folder);
        List<Path> written = new ArrayList<>();
        for (Map.Entry<String, String> text : texts.entrySet()) {
            Path file = folder.resolve(text.getKey());
            Files.createDirectories(file.getParent());
            Files.writeString(file, text.getValue());
            written.add(file);
        }
        return written;
    }

    private void checkName(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        if (!NAME.matcher(name).matches() || SourceVersion.isKeyword(lower)) {
            throw new BotException(name
                    + ": cannot be the name of a class and a package in Java; a name looks like Rover2, letters and"
                    + " digits only");
        }
        boolean isType = lower.equals(BotAddress.SIMULATED)
                || BotFactory.types(ProjectTemplate.class.getClassLoader()).stream()
                        .map(BotType::name)
                        .anyMatch(lower::equals);
        if (isRobot && isType) {
            throw new BotException(name + ": MAJIC has a type of robot of this name; choose another one");
        }
    }

    /** The name must not be that of a class that the sources use. */
    private void checkClassName(String name, Map<String, String> texts) {
        String type = capital(name);
        String used = "(?s).*\\bimport [\\w.]*\\." + type + ";.*";
        if (isInJavaLang(type) || texts.values().stream().anyMatch(text -> text.matches(used))) {
            throw new BotException(name + ": the project uses another class of this name; choose another one");
        }
    }

    private static boolean isInJavaLang(String type) {
        return Object.class.getResource(type + ".class") != null;
    }

    private static void checkFolder(Path folder) throws IOException {
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new BotException(folder + ": is a file; name a folder that does not exist yet");
        }
        if (Files.isDirectory(folder)) {
            try (Stream<Path> entries = Files.list(folder)) {
                if (entries.findAny().isPresent()) {
                    throw new BotException(folder + ": is not empty; name a folder that does not exist yet");
                }
            }
        }
    }

    private String text(String resource) throws IOException {
        String path = (isRobot ? "robot/" : "act/") + resource;
        try (InputStream file = Objects.requireNonNull(ProjectTemplate.class.getResourceAsStream(path), path)) {
            String text = new String(file.readAllBytes(), StandardCharsets.UTF_8);
            boolean isSource = resource.endsWith(".java");
            return isSource ? "package " + example.toLowerCase(Locale.ROOT) + ";\n\n" + text : text;
        }
    }

    private String named(String text, String name) {
        return text.replace(example, capital(name))
                .replace(example.toLowerCase(Locale.ROOT), name.toLowerCase(Locale.ROOT));
    }

    private static String capital(String name) {
        return Character.toUpperCase(name.charAt(0)) + name.substring(1);
    }
}
