package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import javax.swing.JLabel;
import majic.bot.FakeBot;
import majic.bot.MajicBot;
import majic.bot.Unit;
import majic.bot.Value;
import majic.time.TimeSource;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class ReadingsPanelTest {
    @AutoClose
    private final FakeBot bot = FakeBot.on(TimeSource.system());

    private final ReadingsPanel<MajicBot> panel =
            ReadingsPanel.ofParameters("88888 mm", List.of("voltage", "bumped", "wings"));

    @BeforeEach
    void connect() {
        bot.connect();
    }

    @Test
    void showsTheLastValuesOfARobotThatIsNotConnected() {
        bot.cut();

        panel.show(bot, bot.isConnected());

        assertThat(value("voltage").getText()).isEqualTo("12.6 V");
        assertThat(value("voltage").isEnabled()).isFalse();
    }

    @Test
    void showsParametersByName() {
        panel.show(bot, true);

        assertThat(value("voltage").getText()).isEqualTo("12.6 V");
        assertThat(value("bumped").getText()).isEqualTo("no");
    }

    @Test
    void labelsARowInPlainWordsAndNamesTheParameterInTheToolTip() {
        panel.with("distanceFront", robot -> "512 mm");

        JLabel label = Arrays.stream(panel.getComponents())
                .map(JLabel.class::cast)
                .filter(row -> row.getText().equals("distance front"))
                .findFirst()
                .orElseThrow();
        assertThat(label.getToolTipText()).contains("distanceFront");
    }

    @Test
    void leavesOutTheWordAboutOfAnEstimate() {
        bot.tell("voltage", Value.about(12, Unit.V));

        panel.show(bot, true);

        assertThat(value("voltage").getText()).isEqualTo("12 V");
    }

    @Test
    void showsADashForWhatIsUnknownOrNotOnThisRobot() {
        bot.tell("voltage", Value.unknown("no reading yet"));

        panel.show(bot, true);

        assertThat(value("voltage").getText()).isEqualTo(ReadingsPanel.NONE);
        assertThat(value("wings").getText()).isEqualTo(ReadingsPanel.NONE);
    }

    @Test
    void readsNothingWhileItIsHidden() {
        panel.setVisible(false);

        panel.show(bot, true);

        assertThat(value("voltage").getText()).isEqualTo(ReadingsPanel.NONE);
    }

    @Test
    void greysValuesThatAreNotOfNow() {
        panel.show(bot, false);

        assertThat(value("voltage").isEnabled()).isFalse();
    }

    @Test
    void pairsTheFirstReadingsWhereOneColumnIsWideEnough() {
        panel.paired(2, "12.6 V");
        panel.setSize(2 * panel.getMinimumSize().width, 100);
        panel.doLayout();

        assertThat(value("bumped").getY()).isEqualTo(value("voltage").getY());
        assertThat(value("bumped").getX())
                .isGreaterThan(value("voltage").getX() + value("voltage").getWidth());
        assertThat(value("wings").getY()).isGreaterThan(value("voltage").getY());
    }

    @Test
    void putsTheFirstReadingsBelowEachOtherInANarrowColumn() {
        panel.paired(2, "12.6 V");
        panel.setSize(panel.getMinimumSize().width, 100);
        panel.doLayout();

        assertThat(value("bumped").getY()).isGreaterThan(value("voltage").getY());
    }

    private JLabel value(String name) {
        return Arrays.stream(panel.getComponents())
                .filter(label -> name.equals(label.getName()))
                .map(JLabel.class::cast)
                .findFirst()
                .orElseThrow();
    }
}
