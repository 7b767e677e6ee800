package majic.act;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;

/**
 * Arbitrary texts of arguments and roles: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class ArgumentFuzzTest {
    @FuzzTest
    void anArgumentIsWrittenAsItWasRead(byte[] text) {
        ActArgument argument;
        try {
            argument = ActArgument.parse(new String(text, StandardCharsets.UTF_8));
        } catch (IllegalArgumentException e) {
            assertThat(e.getMessage()).isNotBlank();
            return;
        }

        assertThat(ActArgument.parse(argument.toString())).isEqualTo(argument);
        assertThat(argument.parameter().fit(argument.initial())).isEqualTo(argument.initial());
    }

    @FuzzTest
    void aRoleIsWrittenAsItWasRead(byte[] text) {
        Role role;
        try {
            role = Role.parse(new String(text, StandardCharsets.UTF_8));
        } catch (IllegalArgumentException e) {
            assertThat(e.getMessage()).isNotBlank();
            return;
        }

        assertThat(Role.parse(role.toString())).isEqualTo(role);
    }
}
