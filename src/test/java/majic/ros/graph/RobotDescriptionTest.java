package majic.ros.graph;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RobotDescriptionTest {
    @Test
    void theJointsThatSlideAreThoseOfTheTypePrismatic() {
        assertThat(RobotDescription.slidingJoints("""
                        <?xml version="1.0"?>
                        <robot name="r">
                          <link name="base"/>
                          <joint name="wheel" type="continuous"/>
                          <joint name="lift" type="prismatic"><parent link="base"/></joint>
                          <joint type="prismatic" name="finger"/>
                          <transmission><joint name="wheel"/></transmission>
                        </robot>
                        """)).containsExactlyInAnyOrder("lift", "finger");
    }

    @Test
    void aDescriptionThatIsNoXmlHasNone() {
        assertThat(RobotDescription.slidingJoints("")).isEmpty();
        assertThat(RobotDescription.slidingJoints("robot")).isEmpty();
        assertThat(RobotDescription.slidingJoints("<robot><joint")).isEmpty();
    }

    @Test
    void aDescriptionReadsNoFiles(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("joints.xml"), "<joint name='secret' type='prismatic'/>");

        assertThat(RobotDescription.slidingJoints("<!DOCTYPE robot [<!ENTITY e SYSTEM \"" + file.toUri()
                        + "\">]><robot><joint name='lift' type='prismatic'/>&e;</robot>"))
                .doesNotContain("secret");
    }
}
