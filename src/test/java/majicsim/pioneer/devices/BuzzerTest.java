package majicsim.pioneer.devices;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import majicsim.pioneer.PioneerHandling;
import majicsim.pioneer.Rig;
import org.junit.jupiter.api.Test;

/** SAY and SOUNDTOG (ARCOS sheet 6.1). */
class BuzzerTest {
    private static final int SAY = 15;
    private static final int SOUNDTOG = 92;
    private static final byte A4 = 69;
    private static final byte REST = 0;
    private static final byte ABOVE_MIDI = (byte) (127 + 10);

    private final Rig rig = Rig.open();
    private final PioneerHandling handling = rig.robot.handling();

    @Test
    void aTuneIsPlayedInItsOwnTime() {
        rig.text(SAY, (byte) 25, A4, (byte) 5, REST, (byte) 50, ABOVE_MIDI);
        assertThat(handling.soundingHertz()).isEqualTo(440);
        assertThat(rig.step(0.52).robot.handling().soundingHertz()).isZero();
        assertThat(rig.step(0.1).robot.handling().soundingHertz()).isEqualTo(320);
        assertThat(rig.step(1).robot.handling().soundingHertz()).isZero();
        assertThat(handling.played()).containsExactly(new Tone(440, 500), new Tone(0, 100), new Tone(320, 1000));
    }

    @Test
    void aNewTuneTakesTheOldOnesPlace() {
        rig.text(SAY, (byte) 50, A4, (byte) 50, A4).step(0.2);
        rig.text(SAY, (byte) 5, ABOVE_MIDI).step(5);
        assertThat(handling.played()).containsExactly(new Tone(440, 1000), new Tone(320, 100));
    }

    @Test
    void moreThanTwentyPairsAreCutOff() {
        byte[] tune = new byte[60];
        Arrays.fill(tune, (byte) 1);
        rig.text(SAY, tune).step(5);
        assertThat(handling.played()).hasSize(20);
    }

    @Test
    void mutedNothingSoundsUntilTheSoundIsOnAgain() {
        rig.command(SOUNDTOG, 0).text(SAY, (byte) 25, A4);
        assertThat(handling.soundingHertz()).isZero();
        assertThat(rig.step(1).robot.handling().played()).isEmpty();
        rig.command(SOUNDTOG, 1).text(SAY, (byte) 25, A4);
        assertThat(handling.played()).hasSize(1);
    }

    @Test
    void theEndOfTheSessionIsTheEndOfTheTune() {
        rig.text(SAY, (byte) 50, A4, (byte) 50, A4).command(2, 1).step(3);
        assertThat(handling.played()).hasSize(1);
        assertThat(handling.soundingHertz()).isZero();
    }
}
