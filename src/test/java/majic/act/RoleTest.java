package majic.act;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import majic.bot.FakeBot;
import majic.bot.FakeType;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests writing and reading the roles of an act and comparing them with a robot. */
class RoleTest {
    private final MajicBot aibo =
            new FakeBot(new FakeType("aibo"), new BotEnvironment(TimeSource.system(), Settings.inMemory()));

    @ParameterizedTest
    @ValueSource(
            strings = {
                "me",
                "leader pioneer",
                "me aibo|pioneer",
                "follower2 (bumped)",
                "follower+",
                "others+ aibo|pioneer (bumped)",
                "me aibo|pioneer (distanceFront,bumped)",
                "me (play())",
                "me aibo (distanceFront,play(),record())"
            })
    void isReadFromItsOwnText(String text) {
        assertThat(Role.parse(text)).hasToString(text);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "me and you",
                "me aibo,pioneer",
                "me (",
                "me ()",
                "me aibo|",
                "me (play(x))",
                "me (())",
                "me (,a)",
                "me aibo\nx",
                "me+",
                "+"
            })
    void refusesWhatIsNoRole(String text) {
        assertThatThrownBy(() -> Role.parse(text)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void fitsARobotOfItsTypeWithItsParameters() {
        Role role = Role.any(Role.ME).types("Aibo", "pioneer").with("BUMPED").calling("Wag");
        assertThat(role.unfit(aibo)).isEmpty();
    }

    @Test
    void isForAircraftIfItNeedsWhatOnlyTheyCan() {
        assertThat(Role.any(Role.ME).isForAircraft()).isFalse();
        assertThat(Role.any(Role.ME).types("mavlink").calling("arm").isForAircraft())
                .isFalse();
        assertThat(Role.any(Role.ME).calling("arm", "takeoff").isForAircraft()).isTrue();
        assertThat(Role.any(Role.ME).calling("climb").isForAircraft()).isTrue();
        assertThat(Role.any(Role.ME).refusesAircraft(aibo)).isFalse();
    }

    @Test
    void saysWhatARobotLacks() {
        assertThat(Role.any(Role.ME).types("hemisson").unfit(aibo)).contains("is of type aibo, not hemisson");
        assertThat(Role.any(Role.ME).with("sonar3").unfit(aibo)).contains("has no parameter sonar3");
        assertThat(Role.any(Role.ME).with("bumpd").unfit(aibo))
                .contains("has no parameter bumpd; did you mean bumped?");
        assertThat(Role.any(Role.ME).calling("jump").unfit(aibo)).contains("has no command jump");
    }
}
