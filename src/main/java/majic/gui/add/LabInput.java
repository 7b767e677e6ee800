package majic.gui.add;

import javax.swing.JComboBox;
import javax.swing.JLabel;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.gui.kit.MajicDialog;
import majic.lab.LabAccess;
import majic.team.BotFactory;

/** Selects one of the robots of the simulated lab. */
final class LabInput extends AddressInput {
    private static final long serialVersionUID = 1L;

    private final JComboBox<String> robot = new JComboBox<>();

    LabInput(BotFactory factory) {
        robot.setName("labRobot");
        factory.lab().map(LabAccess::robots).ifPresent(all -> all.forEach(robot::addItem));
        if (robot.getItemCount() == 0) {
            add(new JLabel("No lab runs here yet; the menu Lab starts one."), "spanx 2, alignx left");
        } else {
            add(MajicDialog.label("Robot", robot));
            add(robot);
        }
    }

    @Override
    String address() {
        Object chosen = robot.getSelectedItem();
        if (chosen == null) {
            throw new BotException("No simulated lab runs here; start one by the menu Lab, then add its robots");
        }
        return BotAddress.SIMULATED + ":" + chosen;
    }

    @Override
    String advice() {
        return "A robot of the lab takes one connection at a time.";
    }
}
