package majic.act.make;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import majic.act.ActException;
import majic.act.file.InvalidActException;
import org.jspecify.annotations.Nullable;

/** Compiles one source file in memory, for the oldest Java that MAJIC runs on. */
public final class JavaSource {
    private static final String RELEASE = "17";

    private JavaSource() {}

    /**
     * Compiles a file.
     *
     * @return its classes by name
     * @throws ActException if this Java has no compiler
     * @throws InvalidActException with the first error that the compiler found
     */
    public static Map<String, byte[]> compile(Path source) throws IOException {
        return compile(source, ToolProvider.getSystemJavaCompiler());
    }

    static Map<String, byte[]> compile(Path source, @Nullable JavaCompiler compiler) throws IOException {
        if (compiler == null) {
            throw new ActException("this Java has no compiler; install a JDK, or compile " + source.getFileName()
                    + " elsewhere and give the class file");
        }
        if (!Files.isRegularFile(source)) {
            throw new ActException("there is no file " + source);
        }
        DiagnosticCollector<JavaFileObject> found = new DiagnosticCollector<>();
        Map<String, ByteArrayOutputStream> compiled = new HashMap<>();
        try (StandardJavaFileManager files =
                        compiler.getStandardFileManager(found, Locale.ROOT, StandardCharsets.UTF_8);
                InMemory memory = new InMemory(files, compiled)) {
            boolean done = compiler.getTask(null, memory, found, options(), null, files.getJavaFileObjects(source))
                    .call();
            if (!done) {
                throw new InvalidActException(firstError(found));
            }
        }
        Map<String, byte[]> classes = new HashMap<>();
        compiled.forEach((name, bytes) -> classes.put(name, bytes.toByteArray()));
        return classes;
    }

    private static List<String> options() {
        return List.of("--release", RELEASE, "-proc:none", "-g", "-classpath", System.getProperty("java.class.path"));
    }

    private static String firstError(DiagnosticCollector<JavaFileObject> found) {
        List<Diagnostic<? extends JavaFileObject>> errors = found.getDiagnostics().stream()
                .filter(one -> one.getKind() == Diagnostic.Kind.ERROR)
                .toList();
        if (errors.isEmpty()) {
            return "cannot be compiled";
        }
        Diagnostic<? extends JavaFileObject> first = errors.get(0);
        String more = errors.size() == 1 ? "" : " (and " + (errors.size() - 1) + " more)";
        String what = first.getMessage(Locale.ROOT)
                .lines()
                .map(String::strip)
                .reduce((a, b) -> a + ", " + b)
                .orElse("");
        return "cannot be compiled: line " + first.getLineNumber() + ": " + what + more;
    }

    /** Holds the compiled classes in memory. */
    private static final class InMemory extends ForwardingJavaFileManager<JavaFileManager> {
        private final Map<String, ByteArrayOutputStream> compiled;

        InMemory(JavaFileManager files, Map<String, ByteArrayOutputStream> compiled) {
            super(files);
            this.compiled = compiled;
        }

        @Override
        public JavaFileObject getJavaFileForOutput(
                Location location, String className, JavaFileObject.Kind kind, @Nullable FileObject sibling) {
            URI place = URI.create("memory:///" + className.replace('.', '/').replace("$", "%24"));
            return new SimpleJavaFileObject(place, kind) {
                @Override
                public OutputStream openOutputStream() {
                    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
                    compiled.put(className, bytes);
                    return bytes;
                }
            };
        }
    }
}
