import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.lang.module.ModuleFinder;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.jar.JarFile;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import majic.gui.kit.Icons;

/**
 * Makes an image of MAJIC that starts without an installed Java, and an installer of it for this system: .deb, .msi or
 * .dmg. {@code majic package} calls it once the jar is built.
 */
final class Packaging {
    private static final String NAME = "majic";

    /** What jdeps cannot find: the compiler for Make Act, and German names of days and months for dates. */
    private static final List<String> FURTHER_MODULES = List.of("jdk.compiler", "jdk.localedata", "jdk.zipfs");

    /** On Windows, readers of the screen reach Swing through this module. */
    private static final String SCREEN_READERS = "jdk.accessibility";

    /** The elliptic curves of TLS, in a module of their own until Java 21. */
    private static final String CURVES = "jdk.crypto.ec";

    private static final int[] ICON_SIZES = {16, 32, 48, 128, 256};

    private enum Platform {
        LINUX,
        MAC,
        WINDOWS;

        static Platform current() {
            String name = System.getProperty("os.name").toLowerCase(Locale.ROOT);
            return name.startsWith("windows") ? WINDOWS : name.startsWith("mac") ? MAC : LINUX;
        }
    }

    private final Platform platform = Platform.current();
    private final Path home;
    private final Path target;
    private final Path work;

    private Packaging(Path home) {
        this.home = home;
        this.target = home.resolve("target");
        this.work = target.resolve("package");
    }

    /**
     * Makes both in the folder {@code target/package} and prints where they are.
     *
     * @param args MAJIC's folder, in which {@code target/majic.jar} is built
     * @throws IOException if a file cannot be read or written
     */
    public static void main(String[] args) throws IOException {
        try {
            new Packaging(Path.of(args[0]).toAbsolutePath()).make();
        } catch (ToolFailed e) {
            System.err.println("majic: " + e.getMessage());
            System.exit(1);
        }
    }

    private void make() throws IOException {
        delete(work);
        Path input = Files.createDirectories(work.resolve("input"));
        copyProgram(input);
        Path runtime = work.resolve("runtime");
        makeRuntime(input, runtime);
        Path icon = work.resolve(
                NAME + (platform == Platform.WINDOWS ? ".ico" : platform == Platform.MAC ? ".icns" : ".png"));
        Files.write(icon, icon());
        String version = version(input.resolve("majic.jar"));
        run("jpackage", image(input, runtime, icon, version));
        delete(runtime);
        delete(input);
        Path image = work.resolve(platform == Platform.MAC ? NAME + ".app" : NAME);
        print(image);
        run("jpackage", installer(image, icon, version));
        try (Stream<Path> files = Files.list(work)) {
            files.filter(file -> !file.equals(image) && !file.equals(icon))
                    .sorted()
                    .forEach(Packaging::print);
        }
    }

    private void copyProgram(Path input) throws IOException {
        Files.copy(target.resolve("majic.jar"), input.resolve("majic.jar"));
        Path libraries = Files.createDirectory(input.resolve("lib"));
        for (Path library : libraries()) {
            Files.copy(library, libraries.resolve(library.getFileName()));
        }
    }

    private List<Path> libraries() throws IOException {
        try (Stream<Path> files = Files.list(target.resolve("lib"))) {
            return files.filter(file -> file.toString().endsWith(".jar"))
                    .sorted()
                    .toList();
        }
    }

    /** Makes a runtime of those modules of the JDK that the program uses. */
    private void makeRuntime(Path input, Path runtime) throws IOException {
        List<String> modules = new ArrayList<>(List.of(used(input).split(",")));
        modules.addAll(FURTHER_MODULES);
        if (platform == Platform.WINDOWS) {
            modules.add(SCREEN_READERS);
        }
        if (ModuleFinder.ofSystem().find(CURVES).isPresent()) {
            modules.add(CURVES);
        }
        run(
                "jlink",
                List.of(
                        "--add-modules",
                        String.join(",", modules),
                        "--include-locales",
                        "en,de",
                        "--strip-java-debug-attributes",
                        "--no-header-files",
                        "--no-man-pages",
                        "--compress",
                        Runtime.version().feature() < 21 ? "2" : "zip-6",
                        "--output",
                        runtime.toString()));
        shareClassData(runtime);
    }

    private String used(Path input) {
        return run(
                        "jdeps",
                        List.of(
                                "--multi-release",
                                "17",
                                "--ignore-missing-deps",
                                "--print-module-deps",
                                "--class-path",
                                input.resolve("lib") + File.separator + "*",
                                input.resolve("majic.jar").toString()))
                .strip();
    }

    /** Makes the JDK's own class data, with which every start is faster; the image does not depend on it. */
    private static void shareClassData(Path runtime) throws IOException {
        try {
            new ProcessBuilder(runtime.resolve("bin").resolve("java").toString(), "-Xshare:dump")
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start()
                    .waitFor();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private List<String> image(Path input, Path runtime, Path icon, String version) throws IOException {
        List<String> arguments = described(version);
        arguments.addAll(List.of(
                "--type",
                "app-image",
                "--copyright",
                copyright(),
                "--input",
                input.toString(),
                "--main-jar",
                "majic.jar",
                "--main-class",
                "majic.Majic",
                "--runtime-image",
                runtime.toString(),
                "--icon",
                icon.toString(),
                "--dest",
                work.toString()));
        for (String option : javaOptions()) {
            arguments.addAll(List.of("--java-options", option));
        }
        if (platform == Platform.WINDOWS) {
            Path console = Files.writeString(work.resolve("console.properties"), "win-console=true\n");
            arguments.addAll(List.of("--add-launcher", NAME + "-console=" + console));
        }
        return arguments;
    }

    /** Returns what the image and the installer say alike. */
    private static List<String> described(String version) {
        return new ArrayList<>(List.of(
                "--name",
                NAME,
                "--app-version",
                version,
                "--vendor",
                "MAJIC",
                "--description",
                "Commands a team of different robots from one window"));
    }

    private List<String> javaOptions() throws IOException {
        List<String> options =
                new ArrayList<>(Files.readAllLines(home.resolve("config").resolve("java.options")));
        options.removeIf(line -> line.isBlank() || line.startsWith("#"));
        if (Runtime.version().feature() >= 22) {
            options.add("--enable-native-access=ALL-UNNAMED");
        }
        return options;
    }

    private List<String> installer(Path image, Path icon, String version) {
        List<String> arguments = described(version);
        arguments.addAll(List.of(
                "--app-image",
                image.toString(),
                "--license-file",
                home.resolve("LICENSE").toString(),
                "--dest",
                work.toString()));
        arguments.addAll(
                switch (platform) {
                    case LINUX ->
                        List.of(
                                "--icon",
                                icon.toString(),
                                "--resource-dir",
                                home.resolve("src/build/linux").toString(),
                                "--linux-shortcut",
                                "--linux-menu-group",
                                "Education;Science;Robotics",
                                "--linux-app-category",
                                "science");
                    case MAC -> List.of("--icon", icon.toString());
                    case WINDOWS ->
                        List.of("--win-menu", "--win-shortcut", "--win-dir-chooser", "--win-per-user-install");
                });
        return arguments;
    }

    private String copyright() throws IOException {
        return Files.readAllLines(home.resolve("LICENSE")).stream()
                .filter(line -> line.startsWith("Copyright"))
                .findFirst()
                .orElse("MIT licence");
    }

    /** Returns the version as this system takes it: macOS takes none below 1. */
    private String version(Path jar) throws IOException {
        try (JarFile file = new JarFile(jar.toFile())) {
            String version = file.getManifest().getMainAttributes().getValue("Implementation-Version");
            return platform == Platform.MAC ? version.replaceFirst("^0\\.", "1.") : version;
        }
    }

    /** Draws MAJIC's icon as this system takes it: one picture, or several in one file. */
    private byte[] icon() throws IOException {
        if (platform == Platform.LINUX) {
            return picture(256);
        }
        Map<Integer, byte[]> pictures = new LinkedHashMap<>();
        for (int size : ICON_SIZES) {
            pictures.put(size, picture(size));
        }
        return platform == Platform.MAC ? macIcon(pictures) : windowsIcon(pictures);
    }

    private byte[] picture(int size) throws IOException {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(Icons.program(size), "png", png);
        return png.toByteArray();
    }

    /** An .ico file: a head, 16 bytes about each picture, then the pictures, which may be PNG files. */
    private static byte[] windowsIcon(Map<Integer, byte[]> pictures) {
        int head = 6 + 16 * pictures.size();
        ByteBuffer file = ByteBuffer.allocate(head + bytes(pictures)).order(ByteOrder.LITTLE_ENDIAN);
        file.putShort((short) 0).putShort((short) 1).putShort((short) pictures.size());
        int offset = head;
        for (Map.Entry<Integer, byte[]> picture : pictures.entrySet()) {
            byte side = (byte) (picture.getKey() % 256);
            file.put(side).put(side).putShort((short) 0).putShort((short) 1).putShort((short) 32);
            file.putInt(picture.getValue().length).putInt(offset);
            offset += picture.getValue().length;
        }
        pictures.values().forEach(file::put);
        return file.array();
    }

    /** An .icns file: a head, then each picture as a PNG file behind its type and length. */
    private static byte[] macIcon(Map<Integer, byte[]> pictures) {
        Map<Integer, String> types = Map.of(128, "ic07", 256, "ic08");
        pictures.keySet().retainAll(types.keySet());
        ByteBuffer file = ByteBuffer.allocate(8 + 8 * pictures.size() + bytes(pictures));
        file.put("icns".getBytes(StandardCharsets.US_ASCII)).putInt(file.capacity());
        pictures.forEach((size, png) -> file.put(types.get(size).getBytes(StandardCharsets.US_ASCII))
                .putInt(8 + png.length)
                .put(png));
        return file.array();
    }

    private static int bytes(Map<Integer, byte[]> pictures) {
        return pictures.values().stream().mapToInt(png -> png.length).sum();
    }

    /** Runs a tool of the JDK in this process and returns what it printed. */
    private static String run(String tool, List<String> arguments) {
        StringWriter output = new StringWriter();
        StringWriter errors = new StringWriter();
        int status = ToolProvider.findFirst(tool)
                .orElseThrow(() -> new ToolFailed("this JDK has no " + tool + "; use one that has it, such as Temurin"))
                .run(new PrintWriter(output), new PrintWriter(errors), arguments.toArray(String[]::new));
        if (status != 0) {
            throw new ToolFailed(tool + " failed:\n" + (output + "\n" + errors).strip());
        }
        return output.toString();
    }

    private static final class ToolFailed extends RuntimeException {
        private static final long serialVersionUID = 1L;

        ToolFailed(String message) {
            super(message);
        }
    }

    private static void print(Path made) {
        try (Stream<Path> files = Files.walk(made)) {
            long bytes = files.mapToLong(
                            file -> file.toFile().isFile() ? file.toFile().length() : 0)
                    .sum();
            System.out.println(made + " (" + Math.round(bytes / 1e6) + " MB)");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void delete(Path folder) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> files = Files.walk(folder)) {
                files.sorted(Comparator.reverseOrder())
                        .forEach(file -> file.toFile().delete());
            }
        }
    }
}
