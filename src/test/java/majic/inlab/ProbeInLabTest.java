package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import majic.team.BotFactory;
import org.junit.jupiter.api.Test;

class ProbeInLabTest {
    @Test
    void aPioneerTellsItsModelAndNameAndIsFreeAgain() {
        try (LabRig rig = LabRig.exact()) {
            BotFactory factory = rig.session().factory();
            String who = factory.probe("sim:pioneer");

            assertThat(who).matches("a MobileRobots Pioneer, model p3[a-z-]+, named \"[^\"]+\" answers");
            assertThat(factory.probe("sim:pioneer")).isEqualTo(who);
            assertThat(rig.add("pioneer").get("model").toString())
                    .isNotEmpty()
                    .satisfies(model -> assertThat(who).contains("model " + model + ","));
        }
    }

    @Test
    void othersAreCalledByTheirMake() {
        try (LabRig rig = LabRig.exact()) {
            assertThat(rig.session().factory().probe("sim:hemisson"))
                    .isEqualTo("a " + rig.session().factory().type("hemisson").make() + " answers");
        }
    }
}
