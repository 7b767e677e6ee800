package majic.act.file;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.jar.Attributes;
import java.util.jar.Attributes.Name;
import java.util.jar.Manifest;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.act.ActArgument;
import majic.act.ActDetails;
import majic.act.Role;

/**
 * Holds the manifest of an act's file.
 *
 * @param actClass the act's class
 * @param details name, version, author and description of the act
 * @param majicVersion the version of the MAJIC that made the file
 * @param roles the robots that the act needs
 * @param arguments the values that may be given when the act is run
 */
public record ActManifest(
        String actClass, ActDetails details, String majicVersion, List<Role> roles, List<ActArgument> arguments) {
    public static final String PATH = "META-INF/MANIFEST.MF";

    /** The version of the file format that this MAJIC writes and reads. */
    private static final int FORMAT = 1;

    private static final Name ACT_FORMAT = new Name("Act-Format");
    private static final Name ACT_CLASS = new Name("Act-Class");
    private static final Name ACT_NAME = new Name("Act-Name");
    private static final Name ACT_VERSION = new Name("Act-Version");
    private static final Name ACT_AUTHOR = new Name("Act-Author");
    private static final Name ACT_DESCRIPTION = new Name("Act-Description");
    private static final Name ACT_ROLES = new Name("Act-Roles");
    private static final Name MAJIC_VERSION = new Name("Majic-Version");

    /** The beginning of the names under which the arguments are listed, counted from 1. */
    private static final String ACT_ARGUMENT = "Act-Argument-";

    public ActManifest {
        roles = List.copyOf(roles);
        arguments = List.copyOf(arguments);
    }

    /** Parses a manifest, to check signatures with. */
    static Manifest parse(byte[] bytes) throws IOException {
        try {
            return new Manifest(new ByteArrayInputStream(bytes));
        } catch (IOException e) {
            throw new InvalidActException("has a damaged manifest (" + e.getMessage() + ")", e);
        }
    }

    static ActManifest of(Manifest manifest) throws IOException {
        Attributes said = manifest.getMainAttributes();
        checkFormat(said);
        String actClass = text(said, ACT_CLASS);
        if (actClass.isEmpty()) {
            throw new InvalidActException("does not say in its manifest which class is the act (Act-Class)");
        }
        if (!ClassNames.isName(actClass)) {
            throw new InvalidActException("names a class in its manifest that cannot be (Act-Class: " + actClass + ")");
        }
        return new ActManifest(
                actClass,
                details(said, actClass),
                text(said, MAJIC_VERSION),
                roles(text(said, ACT_ROLES)),
                arguments(said));
    }

    /** An act without a name, or with one of invisible characters, has the name of its class. */
    private static ActDetails details(Attributes said, String actClass) {
        String name = ActDetails.named(text(said, ACT_NAME)).name();
        return new ActDetails(
                name.isEmpty() ? ClassNames.simple(actClass) : name,
                text(said, ACT_VERSION),
                text(said, ACT_AUTHOR),
                text(said, ACT_DESCRIPTION));
    }

    private static void checkFormat(Attributes said) throws InvalidActException {
        String format = text(said, ACT_FORMAT);
        if (format.isEmpty()) {
            throw new InvalidActException("is a jar, but no act: its manifest has no Act-Format");
        }
        if (!format.matches("[0-9]{1,6}")) {
            throw new InvalidActException("says a strange Act-Format in its manifest: " + format);
        }
        if (Integer.parseInt(format) > FORMAT) {
            throw new InvalidActException("was made by a newer MAJIC (" + text(said, MAJIC_VERSION) + ", form " + format
                    + "); this one reads form " + FORMAT);
        }
        if (Integer.parseInt(format) < FORMAT) {
            throw new InvalidActException("has the old form " + format + " that no MAJIC reads any more; make it anew");
        }
    }

    private static String text(Attributes said, Name name) {
        String text = said.getValue(name);
        return text == null ? "" : text.strip();
    }

    private static List<Role> roles(String text) throws InvalidActException {
        try {
            return text.isEmpty()
                    ? List.of(Role.any(Role.ME))
                    : Stream.of(text.split(";", -1)).map(Role::parse).toList();
        } catch (IllegalArgumentException e) {
            throw new InvalidActException(
                    "asks in its manifest for robots that cannot be (Act-Roles: " + text + ")", e);
        }
    }

    private static List<ActArgument> arguments(Attributes said) throws InvalidActException {
        List<ActArgument> arguments = new ArrayList<>();
        for (String text = text(said, argument(1));
                !text.isEmpty();
                text = text(said, argument(arguments.size() + 1))) {
            arguments.add(argument(text));
            if (arguments.size() > ActArgument.MOST) {
                throw new InvalidActException("has more than " + ActArgument.MOST + " arguments in its manifest");
            }
        }
        long names = arguments.stream()
                .map(one -> one.name().toLowerCase(Locale.ROOT))
                .distinct()
                .count();
        if (names < arguments.size()) {
            throw new InvalidActException("has two arguments of the same name in its manifest");
        }
        return arguments;
    }

    private static Name argument(int number) {
        return new Name(ACT_ARGUMENT + number);
    }

    private static ActArgument argument(String text) throws InvalidActException {
        try {
            return ActArgument.parse(text);
        } catch (IllegalArgumentException e) {
            throw new InvalidActException("has an argument in its manifest that cannot be (" + e.getMessage() + ")", e);
        }
    }

    /** Returns the manifest as it is written into the file. */
    public byte[] bytes() throws IOException {
        Manifest manifest = new Manifest();
        Attributes said = manifest.getMainAttributes();
        said.put(Name.MANIFEST_VERSION, "1.0");
        said.put(ACT_FORMAT, String.valueOf(FORMAT));
        said.put(ACT_CLASS, actClass);
        said.put(ACT_NAME, details.name());
        said.put(ACT_VERSION, details.version());
        said.put(ACT_AUTHOR, details.author());
        said.put(ACT_DESCRIPTION, details.description());
        said.put(ACT_ROLES, roles.stream().map(Role::toString).collect(Collectors.joining("; ")));
        for (int index = 0; index < arguments.size(); index++) {
            said.put(argument(index + 1), arguments.get(index).toString());
        }
        said.put(MAJIC_VERSION, majicVersion);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        manifest.write(bytes);
        return bytes.toByteArray();
    }
}
