package majic.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Member;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Compares the public API for programs, behaviours and plug-ins with the list in {@code src/test/resources/api.txt}.
 * The list makes each change of the API visible in the commit that makes it. Running this test with
 * {@code -Dapi.write=true} writes the list anew.
 */
class ApiTest {
    private static final Path LIST = Path.of("src/test/resources/api.txt");
    /** The driver test kit is compiled with the tests. */
    private static final String KIT = "majic.drivertest";

    private static final List<String> PACKAGES =
            List.of("majic.act", "majic.bot", "majic.driver", KIT, "majic.environment", "majic.link", "majic.time");

    @Test
    void theApiIsTheListedOne() throws IOException {
        List<String> api = api();
        if (Boolean.getBoolean("api.write")) {
            Files.write(LIST, api);
        }

        assertThat(api)
                .as("the API; after an intended change run mvn test -Dtest=ApiTest -Dapi.write=true, and describe the"
                        + " change in CHANGELOG.md")
                .isEqualTo(Files.readAllLines(LIST));
    }

    private static List<String> api() throws IOException {
        List<Class<?>> types = new ArrayList<>();
        for (String name : PACKAGES) {
            try (Stream<Path> files = Files.list(folder(name))) {
                files.map(file -> file.getFileName().toString())
                        .filter(file -> file.endsWith(".class") && !file.startsWith("package-info"))
                        .map(file -> type(name + "." + file.replace(".class", "")))
                        .filter(ApiTest::isPublic)
                        .forEach(types::add);
            }
        }
        types.sort(Comparator.comparing(Class::getName));
        return types.stream().flatMap(ApiTest::lines).toList();
    }

    private static Path folder(String name) {
        return Path.of(name.equals(KIT) ? "target/test-classes" : "target/classes", name.split("\\."));
    }

    private static Class<?> type(String name) {
        try {
            return Class.forName(name, false, ApiTest.class.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Returns whether other programs can use a type: it and all types around it are public or protected. */
    private static boolean isPublic(Class<?> type) {
        boolean visible = isVisible(type.getModifiers()) && !type.isAnonymousClass() && !type.isLocalClass();
        Class<?> outer = type.getDeclaringClass();
        return visible && (outer == null || isPublic(outer));
    }

    private static boolean isVisible(int modifiers) {
        return Modifier.isPublic(modifiers) || Modifier.isProtected(modifiers);
    }

    private static Stream<String> lines(Class<?> type) {
        Stream<Member> members = Stream.concat(
                Stream.of(type.getDeclaredConstructors()),
                withHiddenBases(type)
                        .flatMap(each -> Stream.of(each.getDeclaredFields(), each.getDeclaredMethods()))
                        .flatMap(Stream::of));
        return Stream.concat(
                Stream.of(head(type)),
                members.filter(member -> isVisible(member.getModifiers()) && !member.isSynthetic())
                        .filter(member -> !isImplied(type, member))
                        .map(member -> "    " + text(member))
                        .sorted());
    }

    /** A type has the members of a base class that other programs cannot use. */
    private static Stream<Class<?>> withHiddenBases(Class<?> type) {
        Class<?> base = type.getSuperclass();
        boolean hidden = base != null && base.getPackage() == type.getPackage() && !isPublic(base);
        return Stream.concat(Stream.of(type), hidden ? withHiddenBases(base) : Stream.empty());
    }

    /** The compiler adds these to each record and each enumeration. */
    private static boolean isImplied(Class<?> type, Member member) {
        return type.isRecord() && List.of("equals", "hashCode", "toString").contains(member.getName())
                || type.isEnum() && List.of("values", "valueOf").contains(member.getName());
    }

    private static String head(Class<?> type) {
        String bases = Stream.concat(
                        Stream.ofNullable(type.getGenericSuperclass()), Stream.of(type.getGenericInterfaces()))
                .map(base -> base.getTypeName())
                .filter(base -> !base.matches("java\\.lang\\.(Object|Record|Enum<.*>)"))
                .collect(Collectors.joining(", "));
        String modifiers = Modifier.toString(type.getModifiers() & ~Modifier.INTERFACE);
        return modifiers + " " + kind(type) + " " + type.getTypeName() + (bases.isEmpty() ? "" : " : " + bases);
    }

    private static String kind(Class<?> type) {
        if (type.isInterface()) {
            return "interface";
        }
        return type.isEnum() ? "enum" : type.isRecord() ? "record" : "class";
    }

    private static String text(Member member) {
        String text;
        if (member instanceof Method method) {
            text = method.toGenericString();
        } else if (member instanceof Constructor<?> constructor) {
            text = constructor.toGenericString();
        } else {
            text = ((Field) member).toGenericString();
        }
        String owner = member.getDeclaringClass().getTypeName() + (member instanceof Executable ? "" : ".");
        String name = member instanceof Method ? owner + "." : owner;
        return (member instanceof Constructor ? text : text.replace(name + member.getName(), member.getName()))
                .replaceAll("\\b(synchronized|native|transient|volatile) ", "");
    }
}
