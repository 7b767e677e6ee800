package majic.act.file;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.act.ActArgument;
import majic.act.ActDetails;
import majic.act.Role;
import majic.text.VisibleText;

/** Describes an act's file in lines of text to show to the user. */
final class ActDescription {
    private ActDescription() {}

    static List<String> of(ActFile file) {
        ActDetails details = file.details();
        return Stream.of(
                        "act: " + details.name() + (details.version().isEmpty() ? "" : " " + details.version()),
                        "author: " + orElse(details.author(), "not said"),
                        "description: " + orElse(details.description(), "none"),
                        "robots: " + file.roles().stream().map(Role::toString).collect(Collectors.joining("; ")),
                        "arguments: " + orElse(arguments(file), "none"),
                        "class: " + file.actClass(),
                        "made with: MAJIC " + orElse(file.majicVersion(), "of an unknown version"),
                        "signed by: " + signers(file.signers()),
                        "SHA-256: " + file.sha256(),
                        "classes in it: " + orElse(String.join(", ", file.classes()), "none; it needs no consent"),
                        "other files in it: " + orElse(String.join(", ", file.resources()), "none"),
                        "packages they use: " + orElse(String.join(", ", file.packages()), "none"))
                .map(VisibleText::of)
                .toList();
    }

    private static String arguments(ActFile file) {
        return file.arguments().stream().map(ActArgument::toString).collect(Collectors.joining("; "));
    }

    private static String signers(List<Signer> signers) {
        return orElse(
                signers.stream()
                        .map(signer -> signer.name() + " (certificate " + signer.fingerprint() + ")")
                        .collect(Collectors.joining(", ")),
                "none");
    }

    private static String orElse(String text, String otherwise) {
        return text.isEmpty() ? otherwise : text;
    }
}
