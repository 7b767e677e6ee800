package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Value;
import majic.inlab.LabRig;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests parameters and commands of the Aibo's driver with the simulated dog, in MAJIC Script. */
class AiboParametersInLabTest {
    @AutoClose
    private final LabRig rig = LabRig.exact();

    private final MajicBot dog = rig.add("aibo");

    @Test
    void aLegMovesToTheCommandedAngle() throws InterruptedException {
        assertThat(rig.run("1 set legLF1 20 500ms")).last().isEqualTo("1 set legLF1 20 500ms: done");

        assertThat(dog.get("legLF1").number()).isCloseTo(20, within(1.0));
        assertThat(dog.get("legLF1Load").number()).isEqualTo(1);
    }

    @Test
    void aLimbIsSetAtOnceAndReadAsAList() throws InterruptedException {
        rig.run("1 set head -10 20 5 -20 400ms", "1 set legRH 10 20 30");

        assertThat(((Value.Many) dog.get("head")).values())
                .zipSatisfy(
                        List.of(-10.0, 20.0, 5.0, -20.0),
                        (angle, told) -> assertThat(angle.number()).isCloseTo(told, within(1.0)));
        assertThat(dog.get("legRH2").number()).isCloseTo(20, within(1.0));
    }

    @Test
    void ledsAreSetAloneAndTogether() throws InterruptedException {
        assertThat(rig.run("1 set leds 0", "1 set ledF3 0.5", "1 set ledBW 0.25 0.5 1", "1 get ledF3,ledF4,ledBW"))
                .endsWith("1 ledF3 = 0.5", "1 ledF4 = 0", "1 ledBW = 0.25, 0.5, 1");
    }

    @Test
    void aFaceGetsItsLightsBack() throws InterruptedException {
        assertThat(rig.run(
                        "1 set ledF 0",
                        "1 set ledF5 0.5",
                        "1 set light on",
                        "1 get ledF5,ledF6",
                        "1 set light off",
                        "1 get ledF5,ledF6"))
                .contains("1 ledF5 = 1", "1 ledF6 = 1")
                .endsWith("1 ledF5 = 0.5", "1 ledF6 = 0");
    }

    @Test
    void theCameraIsSetInWords() throws InterruptedException {
        assertThat(rig.run(
                        "1 set resolution half",
                        "1 set whiteBalance outdoor",
                        "1 set jpegFactor 50",
                        "1 get resolution,whiteBalance,jpegFactor,format"))
                .endsWith("1 resolution = half", "1 whiteBalance = outdoor", "1 jpegFactor = 50", "1 format = jpeg");
    }

    @Test
    void everyParameterCanBeReadFromADog() {
        dog.place(Pose.START);
        assertThat(dog.parameters().stream().filter(Parameter::readable))
                .filteredOn(parameter -> !parameter.name().equals("age"))
                .filteredOn(parameter -> dog.get(parameter.name()) instanceof Value.Unknown)
                .extracting(Parameter::name)
                .isEmpty();
    }

    @Test
    void aRawCommandTellsWhatTheDogAnswers() throws InterruptedException {
        assertThat(rig.run("1 urbi \"1+1; headPan.val = 20 time:200; [1,2]\"", "1 urbi \"a = 3\"", "1 urbi \"1/0\""))
                .satisfiesExactly(
                        sum -> assertThat(sum).endsWith(": 2.000000; [1.000000, 2.000000]"),
                        silent -> assertThat(silent).endsWith(": done, without an answer"),
                        wrong -> assertThat(wrong).contains("failed: the dog says: !!! Division by zero"));
    }

    @Test
    void aRawCommandThatHarmsIsRefusedAndTheNextOneRuns() throws InterruptedException {
        assertThat(rig.run("1 urbi stopall"))
                .containsExactly("1 urbi stopall: failed: \"stopall\" is never sent to a dog: it would harm the dog or "
                        + "other programs on it");
        assertThat(rig.run("1 urbi 7")).containsExactly("1 urbi 7: 7.000000");
    }

    @Test
    void badLinesSayWhatWouldBeRight() throws InterruptedException {
        assertThat(rig.run("1 set legLF2 95", "1 set shutter quick", "1 set legs 0 0 130"))
                .containsExactly(
                        "legLF2 95: outside -9 … 91 deg",
                        "shutter quick: it is one of slow, mid, fast",
                        "legLF3 130: outside -29 … 119 deg");
    }
}
