package majic.ros.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import majic.ros.message.ContactMessage.Contact;
import majic.ros.message.HazardsMessage.Detection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HazardMessagesTest {
    @Test
    void theHazardsOfACreate3AreNumbered() {
        HazardsMessage read =
                HazardsMessage.from(Recorded.json("{'detections':[{'header':{'frame_id':'bump_left'},'type':1},"
                        + "{'type':2},{'type':0},{'type':5},{'type':6},{'type':-3},{'type':'x'}]}"));

        assertThat(read.detections()).startsWith(new Detection(Hazard.BUMP, "bump_left"));
        assertThat(read.detections())
                .extracting(Detection::hazard)
                .containsExactly(
                        Hazard.BUMP,
                        Hazard.CLIFF,
                        Hazard.BACKUP_LIMIT,
                        Hazard.PROXIMITY,
                        Hazard.OTHER,
                        Hazard.OTHER,
                        Hazard.OTHER);
    }

    @Test
    void anEmptyListMeansNoHazard() {
        assertThat(HazardsMessage.from(Recorded.json("{'detections':[]}")).detections())
                .isEmpty();
        assertThatThrownBy(() -> HazardsMessage.from(Recorded.json("{}"))).isInstanceOf(UnusableMessage.class);
    }

    @ParameterizedTest
    @CsvSource({
        "'{\"state\":1,\"bumper\":0}', BUMP, left, true",
        "'{\"state\":0,\"bumper\":1}', BUMP, centre, false",
        "'{\"state\":1,\"sensor\":2,\"bottom\":900}', CLIFF, right, true",
        "'{\"state\":1,\"wheel\":1}', WHEEL_DROP, right, true",
        "'{\"state\":1,\"bumper\":7}', BUMP, 7, true"
    })
    void anEventOfAKobukiIsAboutOneContact(String event, Hazard hazard, String place, boolean active) {
        assertThat(ContactMessage.kobuki(Recorded.json(event)).contacts())
                .containsExactly(new Contact(hazard, place, active));
    }

    @Test
    void theCoreSensorsOfAKobukiHaveTheRightSideInTheLowestBit() {
        assertThat(ContactMessage.kobukiCore(Recorded.json("{'bumper':5,'cliff':2,'wheel_drop':2}"))
                        .contacts())
                .filteredOn(Contact::active)
                .extracting(contact -> contact.hazard() + " " + contact.place())
                .containsExactly("BUMP right", "BUMP left", "CLIFF centre", "WHEEL_DROP left");
        assertThatThrownBy(() -> ContactMessage.kobukiCore(Recorded.json("{'bumper':5}")))
                .isInstanceOf(UnusableMessage.class);
    }

    @Test
    void aTurtleBot3ReportsItsTwoBumpersAsBits() {
        assertThat(ContactMessage.turtleBot3(Recorded.json("{'bumper':2,'cliff':0}"))
                        .contacts())
                .containsExactly(new Contact(Hazard.BUMP, "front", false), new Contact(Hazard.BUMP, "back", true));
    }
}
