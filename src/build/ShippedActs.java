import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.act.ActDetails;
import majic.act.file.ActCatalog;
import majic.act.make.ActMaker;
import majic.script.ScriptAct;

/** Makes the behaviours that come with MAJIC, each from one source in Java or MAJIC Script. The build calls it. */
final class ShippedActs {
    private static final String AUTHOR = "MAJIC";
    private static final Pattern SCRIPT_COMMENT = Pattern.compile("\\A(?:#.*\\R)+");
    private static final Pattern CLASS_COMMENT =
            Pattern.compile("/\\*\\*(.*?)(?:<p>.*?)?\\*/\\s*public\\s+(?:final\\s+)?class", Pattern.DOTALL);

    private ShippedActs() {}

    /**
     * Makes the files, and beside them the index that names them.
     *
     * @param args the folder of the sources, the folder for the files, and MAJIC's version
     * @throws IOException if a source cannot be read or a file not be written
     */
    public static void main(String[] args) throws IOException {
        Path target = Path.of(args[1]);
        Files.createDirectories(target);
        List<Path> sources = sources(Path.of(args[0]));
        for (Path source : sources) {
            Files.write(target.resolve(name(source) + ActCatalog.ENDING), make(source, args[2]));
        }
        Files.write(
                target.resolve("index"), sources.stream().map(ShippedActs::name).toList());
    }

    static List<Path> sources(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.sorted().toList();
        }
    }

    static String name(Path source) {
        return source.getFileName().toString().replaceFirst("\\..*", "");
    }

    private static byte[] make(Path source, String version) throws IOException {
        String text = Files.readString(source);
        ActDetails details = new ActDetails(name(source), version, AUTHOR, description(text));
        if (source.toString().endsWith(".majic")) {
            return ActMaker.save(new ScriptAct(String.valueOf(source.getFileName()), text), details);
        }
        ActMaker maker = ActMaker.from(source);
        return maker.make(maker.onlyAct(), details);
    }

    /** The comment at the head of a script, or the first paragraph of the one at a class. */
    private static String description(String text) {
        Matcher script = SCRIPT_COMMENT.matcher(text);
        if (script.find()) {
            return inOneLine(script.group(), "#");
        }
        Matcher java = CLASS_COMMENT.matcher(text);
        return java.find() ? withoutTags(inOneLine(java.group(1), "*")) : "";
    }

    /** What Javadoc shows: the content of its tags, the label of a link if it has one, and no HTML. */
    private static String withoutTags(String comment) {
        return comment.replaceAll("\\{@link(?:plain)?\\s+\\S+\\s+([^}]+)}", "$1")
                .replaceAll("\\{@\\w+\\s+([^}]*)}", "$1")
                .replaceAll("</?\\w+>", "");
    }

    private static String inOneLine(String comment, String mark) {
        return comment.lines()
                .map(String::strip)
                .map(line ->
                        line.startsWith(mark) ? line.substring(mark.length()).strip() : line)
                .filter(line -> !line.isEmpty())
                .collect(Collectors.joining(" "));
    }
}
