package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.regex.Pattern;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import majic.gui.Contrast;
import majic.gui.WindowAudit;
import majic.team.Member;
import majic.text.MarkedTexts;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Tag("jdk")
class PanelsInLabTest {
    /** What panels show without its being a text: values and units of parameters, and what a robot calls itself. */
    private static final Pattern DATA =
            Pattern.compile("\\b(clear|no|off|remote control|mm|mm/s|s|ms|p3dx-sh|MajicSim|S\\.0)\\b");

    /** Measures panels in the program's own look and fonts, whatever an earlier test has set. */
    @BeforeEach
    void lookAsInTheProgram() throws Exception {
        SwingUtilities.invokeAndWait(FlatLightLaf::setup);
    }

    @ParameterizedTest
    @CsvSource({
        "320, 240, 8, 8, 3",
        "380, 200, 8, 8, 3",
        "470, 260, 8, 8, 3",
        "800, 600, 30, 30, 33",
        "400, 700, 20, 20, 17"
    })
    void noReadingIsCutOffOnAnyRobotsPanel(int width, int height, int ofTheAibo, int ofThePioneer, int ofTheHemisson)
            throws Exception {
        int[] least = {ofTheAibo, ofThePioneer, ofTheHemisson};
        try (LabRig lab = LabRig.exact().withAllRobots()) {
            lab.run("2 move 300", "3 move 100", "1 set headPan -60");
            for (Member member : lab.team().members()) {
                List<JLabel> labels = labels(panel(member, width, height));
                assertThat(labels)
                        .hasSizeGreaterThanOrEqualTo(least[member.number() - 1])
                        .allSatisfy(label -> assertThat(label.getPreferredSize().width)
                                .as(label.getText())
                                .isLessThanOrEqualTo(label.getWidth()));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"380, 200", "470, 260", "800, 600", "400, 700"})
    void drawingAndReadingsShareThePanelWithoutCoveringEachOther(int width, int height) throws Exception {
        try (LabRig lab = LabRig.exact().withAllRobots()) {
            for (Member member : lab.team().members()) {
                JComponent panel = panel(member, width, height);
                Component drawing = panel.getComponent(0);
                assertThat(Math.min(drawing.getWidth(), drawing.getHeight())).isGreaterThan(90);
                for (Component readings : others(panel)) {
                    assertThat(drawing.getBounds().intersects(readings.getBounds()))
                            .isFalse();
                    assertThat(panel.getBounds().contains(readings.getBounds())).isTrue();
                }
            }
        }
    }

    @Test
    void thePanelsSayWhatTheRobotsSay() throws Exception {
        try (LabRig lab = LabRig.exact().withAllRobots()) {
            lab.run("1 set headPan 40", "2 move 300", "3 set beep on");

            assertThat(shown(lab, 1, "headPan")).isEqualTo("40°");
            assertThat(shown(lab, 2, "x"))
                    .isEqualTo(lab.team().members().get(1).bot().get("x").toString());
            assertThat(shown(lab, 3, "beep")).isEqualTo("on");
        }
    }

    @Test
    void everyPartHasANameAndEnoughContrastInBothLooks() throws Exception {
        try (LabRig lab = LabRig.exact().withAllRobots()) {
            for (FlatLaf look : List.of(new FlatDarkLaf(), new FlatLightLaf())) {
                SwingUtilities.invokeAndWait(() -> FlatLaf.setup(look));
                for (Member member : lab.team().members()) {
                    JComponent panel = panel(member, 800, 600);
                    SwingUtilities.invokeAndWait(() -> {
                        panel.setBackground(UIManager.getColor("Panel.background"));
                        assertThat(WindowAudit.nameless(panel)).isEmpty();
                        assertThat(WindowAudit.pale(panel, Contrast.TEXT)).isEmpty();
                    });
                }
            }
        }
    }

    @Test
    @SuppressWarnings("try")
    void everyTextIsFromAResourceBundle() throws Exception {
        Locale before = Locale.getDefault();
        try (MarkedTexts marked = new MarkedTexts();
                LabRig lab = LabRig.exact().withAllRobots()) {
            Locale.setDefault(marked.language());
            List<String> unmarked = new ArrayList<>();
            for (Member member : lab.team().members()) {
                JComponent panel = panel(member, 800, 600);
                SwingUtilities.invokeAndWait(() -> unmarked.addAll(WindowAudit.unmarked(panel, DATA)));
            }
            assertThat(unmarked).isEmpty();
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void thePioneersMapKeepsItsRoomInASmallTab() throws Exception {
        try (LabRig lab = LabRig.exact().withAllRobots()) {
            Component map = panel(lab.team().members().get(1), 320, 240).getComponent(0);
            assertThat(Math.min(map.getWidth(), map.getHeight())).isGreaterThan(100);
        }
    }

    private static List<Component> others(JComponent panel) {
        return Arrays.stream(panel.getComponents())
                .skip(1)
                .filter(Component::isVisible)
                .toList();
    }

    private static String shown(LabRig lab, int number, String reading) throws Exception {
        Member member = lab.team().members().get(number - 1);
        return labels(panel(member, 800, 600)).stream()
                .filter(label -> reading.equals(label.getName()))
                .map(JLabel::getText)
                .findFirst()
                .orElseThrow();
    }

    /** Returns the robot's panel as laid out in a window, without a display. */
    private static JComponent panel(Member member, int width, int height) throws Exception {
        JComponent[] made = new JComponent[1];
        SwingUtilities.invokeAndWait(() -> {
            made[0] = Objects.requireNonNull(member.bot().display());
            made[0].setSize(width, height);
            layOut(made[0]);
        });
        return made[0];
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    private static List<JLabel> labels(Container container) {
        List<JLabel> labels = new ArrayList<>();
        for (Component child : container.getComponents()) {
            if (child instanceof JLabel label && label.isVisible()) {
                labels.add(label);
            } else if (child instanceof Container inner && inner.isVisible()) {
                labels.addAll(labels(inner));
            }
        }
        return labels;
    }
}
