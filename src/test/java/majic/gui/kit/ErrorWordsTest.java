package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.link.Links;
import majic.pioneer.PioneerType;
import majic.text.Advice;
import majic.text.IoReason;
import org.junit.jupiter.api.Test;

class ErrorWordsTest {
    private static final int LEAST_LITERAL = 6;

    @Test
    void aRefusedConnectionIsExplainedInGermanWithItsAdvice() throws IOException {
        int port;
        try (ServerSocket closed = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = closed.getLocalPort();
        }
        String english = String.valueOf(
                catchThrowable(() -> Links.of("//127.0.0.1:" + port, 1, 1).open(2000))
                        .getMessage());
        String german = ErrorWords.german(Advice.after(english, new PioneerType().advice()));
        assertThat(german)
                .isEqualTo("auf 127.0.0.1 port " + port + " wartet kein Programm auf Verbindungen. Ist der Roboter"
                        + " eingeschaltet, sein serielles Kabel oder seine Netzwerkbrücke eingesteckt und kein anderes"
                        + " Programm mit ihm verbunden? Ein Pioneer spricht mit einem Programm zur selben Zeit; sein"
                        + " Port im Netzwerk ist meist 8101.");
    }

    @Test
    void aReasonInAGapIsTranslatedToo() {
        String english = "/no/such/lap.majic: cannot be written (" + IoReason.of(new NoSuchFileException("x")) + ")";
        assertThat(ErrorWords.german(english))
                .isEqualTo("/no/such/lap.majic: lässt sich nicht schreiben (es gibt keinen solchen Ordner und keine"
                        + " solche Datei)");
    }

    @Test
    void anUnknownSentenceStaysAsItIs() {
        assertThat(ErrorWords.german("the moon is full; wait. Then try again."))
                .isEqualTo("the moon is full; wait. Then try again.");
    }

    @Test
    void anEnglishWindowShowsTheSentencesAsTheyAre() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.ENGLISH);
            assertThat(ErrorWords.of("it is not allowed")).isEqualTo("it is not allowed");
            Locale.setDefault(Locale.GERMAN);
            assertThat(ErrorWords.of("it is not allowed")).isEqualTo("es ist nicht erlaubt");
        } finally {
            Locale.setDefault(before);
        }
    }

    /** A sentence that was changed in the program would no longer be translated. */
    @Test
    void everyEnglishSentenceOfTheListIsInTheProgram() throws IOException {
        String program = sources();
        List<String> gone = list().stream()
                .flatMap(line -> Arrays.stream(line.split(" => ")[0].split("\\{\\d}")))
                .map(String::strip)
                .filter(part -> part.length() >= LEAST_LITERAL)
                .filter(part -> !program.contains(part.replace("\"", "\\\"")))
                .filter(part -> !isOfTheSystem(part))
                .toList();
        assertThat(gone).isEmpty();
    }

    private static boolean isOfTheSystem(String part) {
        return List.of("is a directory", "no space left on device", "read-only file system")
                .contains(part);
    }

    private static List<String> list() throws IOException {
        return Files.readAllLines(Path.of("src/main/resources/majic/gui/kit/errors_de.txt"), StandardCharsets.UTF_8)
                .stream()
                .filter(line -> line.contains(" => "))
                .toList();
    }

    /** Returns all sources, with the pieces of each text joined. */
    private static String sources() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/main/java"))) {
            return files.filter(file -> file.toString().endsWith(".java"))
                    .map(ErrorWordsTest::read)
                    .collect(Collectors.joining("\n"))
                    .replaceAll("\"\\s*\\+\\s*\"", "");
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
