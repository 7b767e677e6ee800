package majic.act;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import majic.bot.Parameter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What an act asks of a robot can be written, read and held against a robot. */
class RoleTest {
    private static final List<Parameter> PARAMETERS = List.of(Parameter.yesNo("bumped", "whether it touches"));

    @ParameterizedTest
    @ValueSource(
            strings = {
                "me",
                "leader pioneer",
                "me aibo|pioneer",
                "follower2 (bumped)",
                "follower+",
                "others+ aibo|pioneer (bumped)",
                "me aibo|pioneer (distanceFront,bumped)"
            })
    void isReadFromItsOwnText(String text) {
        assertThat(Role.parse(text)).hasToString(text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "me and you", "me aibo,pioneer", "me (", "me ()", "me aibo|", "me aibo\nx", "me+", "+"})
    void refusesWhatIsNoRole(String text) {
        assertThatThrownBy(() -> Role.parse(text)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void fitsARobotOfItsTypeWithItsParameters() {
        Role role = Role.any(Role.ME).types("Aibo", "pioneer").with("BUMPED");
        assertThat(role.unfit("aibo", PARAMETERS)).isEmpty();
    }

    @Test
    void saysWhatARobotLacks() {
        assertThat(Role.any(Role.ME).types("aibo").unfit("hemisson", PARAMETERS))
                .contains("is of type hemisson, not aibo");
        assertThat(Role.any(Role.ME).with("sonar3").unfit("aibo", PARAMETERS)).contains("has no parameter sonar3");
    }
}
