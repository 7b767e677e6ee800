package majic.hemisson.modules;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/** The modules that K-Team sold, by address and by the letter of the RoadNarrows firmware (Hemisson sheet 9 and 10). */
enum ModuleKind {
    LINEAR_CAMERA("linear camera", 0xC0, 'L'),
    ULTRASONIC("ultrasonic sensor", 0xE0, 'U'),
    SPEECH("text to speech", 0xC4, 'T'),
    LCD("LCD", 0xA0, 'D'),
    GENERAL_IO("general I/O", 0xD0, 'G'),
    BASIC_STAMP("BasicStamp", -1, '2');

    private final String label;
    private final int address;
    private final char letter;

    ModuleKind(String label, int address, char letter) {
        this.label = label;
        this.address = address;
        this.letter = letter;
    }

    String label() {
        return label;
    }

    /** The module with a write address; null if it is none of these. */
    static @Nullable ModuleKind at(int address) {
        return Arrays.stream(values())
                .filter(kind -> kind.address == address)
                .findFirst()
                .orElse(null);
    }

    /** The module with a RoadNarrows letter; null if it is none of these. */
    static @Nullable ModuleKind of(char letter) {
        return Arrays.stream(values())
                .filter(kind -> kind.letter == letter)
                .findFirst()
                .orElse(null);
    }

    /** Its parameters and commands; null for a module without known commands. */
    @Nullable
    ExtensionModule module(boolean roadNarrows) {
        return switch (this) {
            case LINEAR_CAMERA -> roadNarrows ? LinearCamera.roadNarrows() : LinearCamera.stock();
            case ULTRASONIC -> roadNarrows ? new RoadNarrowsUltrasonic() : new Ultrasonic();
            case SPEECH -> roadNarrows ? new RoadNarrowsSpeech() : new Speech();
            case LCD -> new Lcd();
            case GENERAL_IO -> new GeneralIo();
            case BASIC_STAMP -> null;
        };
    }
}
