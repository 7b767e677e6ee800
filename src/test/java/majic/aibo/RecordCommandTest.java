package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import javax.sound.sampled.AudioFileFormat;
import javax.sound.sampled.AudioSystem;
import majic.bot.LinkLost;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordCommandTest {
    private static final int SENSORS = 1;
    private static final String BLOCK = "BIN 2048 raw 2 16000 16 1 1\n" + "a".repeat(2048);

    @TempDir
    Path folder;

    @AutoClose
    private final DrivenAibo driven = DrivenAibo.lying().connected();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @Test
    void theSubscriptionEndsOnTheDogByItselfAndByACommand() {
        assertThatThrownBy(() -> record(folder.resolve("a.wav")))
                .hasMessage("the dog's microphone has sent nothing for 2 s");

        String order = dog.received("micro.val").get(0);
        String tag = order.substring(0, order.indexOf(':'));
        assertThat(order).matches("\\w+: timeout\\(7000\\) loop \\{ \\w+: micro\\.val \\}");
        dog.awaitReceived("stop " + tag);
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aRefusalIsQuotedAndNoFileIsWritten() {
        CompletableFuture<String> recording = recording(folder.resolve("a.wav"));

        dog.say(SENSORS, ear(), "!!! Unknown identifier: micro.val");

        assertThatThrownBy(() -> dog.clock().join(recording))
                .hasMessageEndingWith("the dog refuses: Unknown identifier: micro.val");
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aLostLinkLeavesAShorterFileAndReportsItsLength() throws Exception {
        Path file = folder.resolve("a.wav");
        CompletableFuture<String> recording = recording(file);
        dog.say(SENSORS, ear(), BLOCK);
        dog.set("power()", "0.420000");
        dog.say(SENSORS, "power", "*** Battery at 42 %");
        untilBattery(42);

        dog.hangUp();

        assertThatThrownBy(() -> dog.clock().join(recording)).hasCauseInstanceOf(LinkLost.class);
        assertThat(driven.notices).contains("the recording was not finished: 0.03 s in " + file);
        AudioFileFormat kept = AudioSystem.getAudioFileFormat(file.toFile());
        assertThat(kept.getFrameLength()).isEqualTo(512);
    }

    @Test
    void secondsAreBounded() {
        assertThatThrownBy(() -> aibo.run("record", List.of(Value.of(61, Unit.S), Value.text("a.wav"))))
                .hasMessage("seconds 61 s: outside 1 … 60 s");
    }

    @Test
    void aFileThatCannotBeCreatedIsReportedAtOnce() {
        Path nowhere = folder.resolve("none").resolve("a.wav");

        assertThatThrownBy(() -> record(nowhere)).hasMessage(nowhere + ": there is no such folder");
        assertThat(dog.received("micro.val")).isEmpty();
    }

    /** Waits until the driver has processed all earlier messages of the dog. */
    private void untilBattery(int percent) {
        dog.clock().until(() -> aibo.get("battery").equals(Value.of(percent, Unit.PERCENT)));
    }

    private String ear() {
        dog.awaitReceived("micro.val");
        return dog.received("micro.val").get(0).replaceAll(".*\\{ (\\w+):.*", "$1");
    }

    private CompletableFuture<String> recording(Path file) {
        return dog.clock().aside(() -> record(file));
    }

    private String record(Path file) {
        return aibo.run("record", List.of(Value.of(5, Unit.S), Value.text(file.toString())));
    }
}
