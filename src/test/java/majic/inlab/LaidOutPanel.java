package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import majic.bot.MajicBot;
import majic.gui.Contrast;
import majic.gui.WindowAudit;

/** The panel of a robot, laid out as in a window, without a display. */
public final class LaidOutPanel {
    /** A drawing that is smaller shows nothing, px. */
    private static final int LEAST_DRAWING_PX = 90;

    private final JComponent panel;

    private LaidOutPanel(JComponent panel, int width, int height) {
        this.panel = panel;
        panel.setSize(width, height);
        layOut(panel);
    }

    /** Makes the panel of a robot in the present look. */
    public static LaidOutPanel of(MajicBot bot, int width, int height) throws Exception {
        return of(() -> Objects.requireNonNull(bot.display()), width, height);
    }

    /** Lays out a panel that is made on the event dispatch thread. */
    public static LaidOutPanel of(Callable<JComponent> maker, int width, int height) throws Exception {
        List<LaidOutPanel> made = new ArrayList<>();
        onEventThread(() -> made.add(new LaidOutPanel(maker.call(), width, height)));
        return made.get(0);
    }

    private static void onEventThread(Callable<?> task) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            try {
                task.call();
            } catch (Exception e) {
                throw new IllegalStateException(e);
            }
        });
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    /** Measures panels in the program's own look and fonts, whatever an earlier test has set. */
    public static void lookAsInTheProgram() throws Exception {
        SwingUtilities.invokeAndWait(FlatLightLaf::setup);
    }

    /** Checks, in both looks, that all parts of the panels have names, and that all texts can be read. */
    public static void checkNamesAndContrast(List<MajicBot> bots, int width, int height) throws Exception {
        for (FlatLaf look : List.of(new FlatDarkLaf(), new FlatLightLaf())) {
            SwingUtilities.invokeAndWait(() -> FlatLaf.setup(look));
            for (MajicBot bot : bots) {
                JComponent panel = of(bot, width, height).panel;
                SwingUtilities.invokeAndWait(() -> {
                    panel.setBackground(UIManager.getColor("Panel.background"));
                    assertThat(WindowAudit.nameless(panel)).isEmpty();
                    assertThat(WindowAudit.pale(panel, Contrast.TEXT)).isEmpty();
                });
            }
        }
    }

    /** Returns the texts that are neither from a resource bundle, whose texts are marked, nor data. */
    public List<String> unmarked(Pattern data) throws Exception {
        List<String> unmarked = new ArrayList<>();
        SwingUtilities.invokeAndWait(() -> unmarked.addAll(WindowAudit.unmarked(panel, data)));
        return unmarked;
    }

    /** Checks that the drawing has room, and that it and the other parts do not cover each other. */
    public void checkThatNothingIsCovered() {
        assertThat(drawingSide()).isGreaterThan(LEAST_DRAWING_PX);
        assertThat(Stream.of(panel.getComponents()).skip(1).filter(Component::isVisible))
                .allSatisfy(part -> {
                    assertThat(drawing().getBounds().intersects(part.getBounds()))
                            .isFalse();
                    assertThat(panel.getBounds().contains(part.getBounds())).isTrue();
                });
    }

    /** Checks that the texts of at least this many labels are shown in full. */
    public void checkThatNoTextIsCut(int labels) {
        assertThat(visible(JLabel.class))
                .hasSizeGreaterThanOrEqualTo(labels)
                .allSatisfy(label -> assertThat(label.getPreferredSize().width)
                        .as(label.getText())
                        .isLessThanOrEqualTo(label.getWidth()));
    }

    private Component drawing() {
        return panel.getComponent(0);
    }

    /** Returns the shorter side of the drawing, px. */
    public int drawingSide() {
        return Math.min(drawing().getWidth(), drawing().getHeight());
    }

    /** Returns the text of the label with a name. */
    public String text(String name) {
        return label(name).getText();
    }

    public JLabel label(String name) {
        return visible(JLabel.class).stream()
                .filter(label -> name.equals(label.getName()))
                .findFirst()
                .orElseThrow();
    }

    /** Returns the visible components of a class, without those inside of them. */
    public <T extends Component> List<T> visible(Class<T> kind) {
        return visible(panel, kind);
    }

    private static <T extends Component> List<T> visible(Container container, Class<T> kind) {
        List<T> found = new ArrayList<>();
        for (Component child : container.getComponents()) {
            if (child.isVisible() && kind.isInstance(child)) {
                found.add(kind.cast(child));
            } else if (child.isVisible() && child instanceof Container inner) {
                found.addAll(visible(inner, kind));
            }
        }
        return found;
    }
}
