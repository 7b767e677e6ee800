package majic.program;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import majic.act.make.JavaSource;

/** The jar of a plug-in, or of a library, for one test. */
final class PluginJar {
    private final Map<String, byte[]> files = new LinkedHashMap<>();

    private PluginJar() {}

    /** Creates a jar that names types of robots, each line of the text as it is in the file. */
    static PluginJar of(String services) {
        PluginJar jar = library();
        jar.files.put("META-INF/services/majic.bot.BotType", services.getBytes(StandardCharsets.UTF_8));
        return jar;
    }

    /** Creates a jar that names none. */
    static PluginJar library() {
        return new PluginJar();
    }

    /** Adds classes of the examples. */
    PluginJar with(String... classes) throws IOException {
        for (String name : classes) {
            with(name, code(name));
        }
        return this;
    }

    PluginJar with(String name, byte[] code) {
        files.put(name + ".class", code);
        return this;
    }

    private static byte[] code(String name) throws IOException {
        try (InputStream code = PluginJar.class.getResourceAsStream("/" + name + ".class")) {
            return code.readAllBytes();
        }
    }

    /**
     * Compiles a type of robot with a name, whose label is that of a class {@code Library} beside it.
     *
     * @param folder for the source
     */
    static Map<String, byte[]> compile(Path folder, String name, String label) throws IOException {
        String type = Character.toUpperCase(name.charAt(0)) + name.substring(1);
        Path source = Files.createDirectories(folder).resolve(type + ".java");
        Files.writeString(source, """
                public class %s implements majic.bot.BotType {
                    private final String label = Library.label();
                    public String name() { return "%s"; }
                    public String label() { return label; }
                    public String make() { return label; }
                    public java.util.List<Reach> reaches() { return java.util.List.of(Reach.TCP); }
                    public int defaultPort(String scheme) { return 0; }
                    public String advice() { return ""; }
                    public majic.bot.MajicBot create(majic.bot.BotAddress address, majic.environment.BotEnvironment environment) {
                        return Other.make();
                    }
                }
                class Library { static String label() { return "%s"; } }
                class Other { static majic.bot.MajicBot make() { return null; } }
                """.formatted(type, name, label));
        return JavaSource.compile(source);
    }

    void write(Path file) throws IOException {
        Files.createDirectories(file.getParent());
        try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(file))) {
            for (Map.Entry<String, byte[]> entry : files.entrySet()) {
                jar.putNextEntry(new JarEntry(entry.getKey()));
                jar.write(entry.getValue());
            }
        }
    }
}
