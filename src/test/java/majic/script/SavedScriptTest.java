package majic.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.lang.reflect.Field;
import majic.act.ActException;
import majic.act.MajicAct;
import majic.act.file.ActFile;
import majic.act.file.ActTrust;
import majic.environment.Settings;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A saved script act is read back as it was, or refused when its file was made by something else. */
class SavedScriptTest {
    private static ScriptAct with(String field, @Nullable String value) throws ReflectiveOperationException {
        ScriptAct act = new ScriptAct("there", "me move 100");
        Field changed = ScriptAct.class.getDeclaredField(field);
        changed.setAccessible(true);
        changed.set(act, value);
        return act;
    }

    private static MajicAct readBack(ScriptAct act) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(act);
        }
        return ActFile.of("odd.act", bytes.toByteArray()).load(new ActTrust(Settings.inMemory()));
    }

    @ParameterizedTest
    @CsvSource({
        "text, , odd.act is damaged: its script is missing",
        "title, , odd.act is damaged: its script is missing",
        "text, me move, odd.act is damaged: there:1:",
        "text, '', odd.act is damaged: there:1:1: no robot is commanded"
    })
    void whatIsNoScriptIsRefused(String field, @Nullable String value, String why) throws Exception {
        ScriptAct act = with(field, value);
        assertThatThrownBy(() -> readBack(act)).isInstanceOf(ActException.class).hasMessageStartingWith(why);
    }

    @Test
    void aScriptIsReadAsItWasSaved() throws Exception {
        assertThat(((ScriptAct) readBack(new ScriptAct("there", "me move 100"))).text())
                .isEqualTo("me move 100");
    }
}
