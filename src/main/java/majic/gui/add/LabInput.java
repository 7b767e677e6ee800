package majic.gui.add;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.gui.kit.EventThread;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.Paragraph;
import majic.lab.LabAccess;
import majic.team.BotFactory;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/** Selects one of the robots of the simulated lab; offers to start the lab while there is none. */
final class LabInput extends AddressInput {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(LabInput.class);

    private final transient BotFactory factory;
    private final transient @Nullable Runnable startLab;
    private final JComboBox<String> robot = new JComboBox<>();
    private final Paragraph problem = new Paragraph("labProblem", 1, 30);

    /**
     * Creates the input.
     *
     * @param startLab starts a lab, may block; null if none can be started
     */
    LabInput(BotFactory factory, @Nullable Runnable startLab) {
        this.factory = factory;
        this.startLab = startLab;
        robot.setName("labRobot");
        show(robots());
    }

    private List<String> robots() {
        return factory.lab().map(LabAccess::robots).orElse(List.of());
    }

    private void show(List<String> robots) {
        removeAll();
        robot.removeAllItems();
        robots.forEach(robot::addItem);
        if (robots.isEmpty()) {
            offerLab();
        } else {
            add(MajicDialog.label(TEXTS.get("robot"), robot));
            add(robot);
        }
        revalidate();
        repaint();
    }

    private void offerLab() {
        add(new JLabel(TEXTS.get("noLab")), "skip 1, wrap");
        if (startLab != null) {
            JButton start = new JButton(TEXTS.get("startLab"));
            start.setName("startLab");
            start.addActionListener(event -> start(start, startLab));
            add(start, "skip 1, grow 0, wrap");
            add(problem, "skip 1, wmin 0");
        }
    }

    private void start(JButton button, Runnable lab) {
        button.setEnabled(false);
        EventThread.background(
                "starting the lab",
                () -> {
                    lab.run();
                    EventThread.later(() -> show(robots()));
                },
                reason -> {
                    button.setEnabled(true);
                    problem.show(reason, true);
                });
    }

    @Override
    String address() {
        Object chosen = robot.getSelectedItem();
        if (chosen == null) {
            throw new BotException(TEXTS.get("startLabFirst"));
        }
        return BotAddress.SIMULATED + ":" + chosen;
    }

    @Override
    boolean fill(BotAddress address) {
        boolean isHere = address.scheme().equals(BotAddress.SIMULATED) && robots().contains(address.rest());
        if (isHere) {
            robot.setSelectedItem(address.rest());
        }
        return isHere;
    }

    @Override
    String advice() {
        return TEXTS.get("oneConnection");
    }
}
