package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majic.bot.BotAddress;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The pace of the dog's legs, and the calibration factors of its gaits. */
class PaceTest {
    @AutoClose
    private final DrivenAibo driven = DrivenAibo.standing();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @BeforeEach
    void connect() {
        dog.set("robot.walkspeed", "900.000000");
        dog.set("robot.turnspeed", "1000.000000");
        aibo.connect();
    }

    @Test
    void aSlowerCruiseSlowsTheLegsAndTheEstimateFollows() {
        aibo.set("cruise", 41.667);

        assertThat(aibo.move(40).amount()).isEqualTo(Value.about(40, Unit.MM));

        assertThat(dog.received("robot.walkspeed = ")).containsExactly("robot.walkspeed = 2000");
        assertThat(dog.received("robot.walk(")).singleElement().asString().contains("robot.walk(960)");
    }

    @Test
    void turnsHaveAPaceOfTheirOwn() {
        aibo.set("cruiseTurn", 50);

        aibo.turn(-10);

        assertThat(dog.received("robot.turnspeed = ")).containsExactly("robot.turnspeed = 719");
        assertThat(dog.received("robot.walkspeed = ")).isEmpty();
    }

    @Test
    void withoutASettingTheLegsMoveAtTheirUsualPaceInBothDirections() {
        driven.settings.put(key("backward"), "21");

        aibo.move(-10);

        assertThat(dog.received("robot.walkspeed = ")).containsExactly("robot.walkspeed = 1000");
        assertThat(dog.received("robot.walk(")).singleElement().asString().contains("robot.walk(-210)");
    }

    @Test
    void aPaceOutsideTheRangeIsRefused() {
        assertThatThrownBy(() -> aibo.set("cruise", 200)).hasMessageContaining("outside 33.3 … 128");
        assertThatThrownBy(() -> aibo.set("cruise", 10)).hasMessageContaining("outside 33.3 … 128");
        assertThatThrownBy(() -> aibo.drive(200, 0)).hasMessageContaining("outside");
    }

    @Test
    void aDriveHasTheRequestedSpeed() {
        aibo.drive(-60, 10);
        dog.awaitReceived("robot.walk(-600)");

        assertThat(dog.received("robot.walkspeed = ")).contains("robot.walkspeed = 1389");
    }

    @Test
    void closingRestoresThePaceForOtherPrograms() {
        aibo.set("cruise", 60);
        aibo.move(10);

        aibo.close();

        dog.awaitReceived("robot.walkspeed = 900");
        assertThat(dog.received("robot.turnspeed = ")).isEmpty();
    }

    @Test
    void aDogThatDidNotWalkKeepsItsPace() {
        aibo.close();

        assertThat(dog.received("speed =")).isEmpty();
    }

    @Test
    void aFallenDogIsNotDriven() {
        aibo.close();
        dog.set("robot.MyguessPosition()", "\"side\"");
        try (MajicAibo fallen = new MajicAibo(new BotAddress("aibo", dog.address()), dog.environment())) {
            fallen.connect();

            assertThatThrownBy(() -> fallen.drive(50, 0)).hasMessageContaining("put it on its feet");
            assertThat(dog.received("robot.walk(")).isEmpty();
        }
    }

    @Test
    void aCalibrationFactorCanBeSetAndIsStored() {
        aibo.set("forwardFactor", 6);

        assertThat(driven.settings.get(key("forward"))).contains("6.000");
        assertThat(aibo.get("cruise").number()).isCloseTo(166.7, within(0.1));
        assertThatThrownBy(() -> aibo.set("forwardFactor", 100)).hasMessageContaining("outside 3 … 48");
    }

    @Test
    void noFactorIsStoredBeforeAMeasurement() {
        assertThatThrownBy(() -> calibrate("forward", Value.of(940, Unit.MM)))
                .hasMessageContaining("\"calibrate forward\" alone moves it first");
        assertThat(driven.settings.get(key("forward"))).isEmpty();
    }

    private String calibrate(String direction, Value measured) {
        return aibo.run("calibrate", List.of(Value.text(direction), measured));
    }

    private String key(String gait) {
        return "aibo." + dog.address().substring(2) + "." + gait;
    }
}
