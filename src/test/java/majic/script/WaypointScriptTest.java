package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.bot.Pose;
import majic.nav.Destination;
import org.junit.jupiter.api.Test;

class WaypointScriptTest {
    @Test
    void aWayIsAnActWithALineForEachPlace() {
        String script =
                WaypointScript.of(List.of(new Destination(1200.4, -300), new Destination(new Pose(0, 500, 90), true)));

        assertThat(script.lines())
                .containsExactly("# Goes to 2 places of the map.", "me goto 1200 -300", "me goto 0 500 90");
        assertThat(new ScriptAct("way.majic", script).roles()).hasSize(1);
    }
}
