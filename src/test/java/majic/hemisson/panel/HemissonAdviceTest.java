package majic.hemisson.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import java.util.stream.Stream;
import majic.bot.MajicBot.Connection;
import majic.hemisson.line.LinkQuality;
import majic.hemisson.line.MotorValues;
import majic.hemisson.panel.HemissonScene.Line;
import majic.panel.StatusLight;
import org.junit.jupiter.api.Test;

/** The advice and the status lights of the Hemisson's tab. */
class HemissonAdviceTest {
    private static final long SECOND = 1_000_000_000;

    private final HemissonAdvice advice = new HemissonAdvice();
    private final HemissonLights lights = new HemissonLights();

    @Test
    void adviceIsShownExactlyWhileAnUnreachableRobotMayBeMoving() {
        assertThat(advice.on(Scenes.standing(Scenes.LOST_MOVING), 0).text()).contains("lift it", "5 on a TV remote");
        assertThat(advice.on(Scenes.standing(Scenes.LOST_MOVING), 0).urgent()).isTrue();
        assertThat(advice.on(Scenes.standing(Scenes.LOST), 0).text()).isEmpty();
    }

    @Test
    void aRefusalStaysForSomeSeconds() {
        advice.refused("ledLeft: no answer", 0);

        assertThat(advice.on(Scenes.standing(Scenes.WELL), 7 * SECOND).text()).isEqualTo("ledLeft: no answer");
        assertThat(advice.on(Scenes.standing(Scenes.WELL), 9 * SECOND).text()).isEmpty();
    }

    @Test
    void aRefusalAndARunningModeAreInTheLanguageOfTheWindow() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMAN);
            advice.refused("ledLeft: no answer within 300 ms", 0);

            assertThat(advice.on(Scenes.standing(Scenes.WELL), SECOND).text())
                    .isEqualTo("ledLeft: keine Antwort innerhalb von 300 ms");
            assertThat(light("mode", Scenes.withSwitches(Scenes.DANCE, Scenes.DANCE)))
                    .isEqualTo("WARNING Tanz");
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void aRobotOutOfControlIsMoreUrgentThanARefusal() {
        advice.refused("ledLeft: no answer", 0);

        assertThat(advice.on(Scenes.standing(Scenes.LOST_MOVING), SECOND).text())
                .contains("lift it");
    }

    @Test
    void anotherRunningModeIsShownByItsName() {
        HemissonScene dancing = Scenes.withSwitches(Scenes.DANCE, Scenes.DANCE);

        assertThat(advice.on(dancing, 0).text()).contains("dance", "marked 1");
        assertThat(advice.on(dancing, 0).urgent()).isFalse();
        assertThat(light("mode", dancing)).isEqualTo("WARNING dance");
    }

    @Test
    void switchesMovedAfterTheStartAreReported() {
        assertThat(light("mode", Scenes.withSwitches(Scenes.REMOTE, Scenes.DANCE)))
                .isEqualTo("WARNING switches moved since its start");
        assertThat(light("mode", Scenes.standing(Scenes.WELL))).isEqualTo("GOOD remote control");
    }

    @Test
    void theQualityOfTheLineIsShown() {
        LinkQuality quality = new LinkQuality(4.25, 100, 2, 1, 0);

        assertThat(line(quality, false, 0.1)).isEqualTo("GOOD link 4.3 ms");
        assertThat(line(quality, true, 0.1)).isEqualTo("WARNING answers missing");
        assertThat(line(quality, true, 1.24)).isEqualTo("WARNING silent 1.2 s");
        assertThat(light("line", Scenes.standing(Scenes.LOST))).isEqualTo("ALARM link lost");
    }

    @Test
    void motorsAreShownByTheValuesSentAndNotAsTurning() {
        assertThat(light("motors", Scenes.driving(new MotorValues(3, 3)))).isEqualTo("GOOD moving");
        assertThat(light("motors", Scenes.driving(MotorValues.STILL))).isEqualTo("QUIET stopped");
        assertThat(light("motors", Scenes.dancing())).isEqualTo("WARNING moves by itself");
        assertThat(light("motors", Scenes.standing(Scenes.LOST_MOVING))).isEqualTo("ALARM may be moving");
    }

    private String line(LinkQuality quality, boolean missing, double silentS) {
        return light("line", Scenes.standing(new Line(Connection.CONNECTED, quality, missing, silentS, false)));
    }

    private String light(String name, HemissonScene view) {
        lights.show(view);
        return Stream.of(lights.panel().getComponents())
                .map(StatusLight.class::cast)
                .filter(light -> light.getName().equals(name))
                .map(light -> light.kind() + " " + light.getText())
                .findFirst()
                .orElseThrow();
    }
}
