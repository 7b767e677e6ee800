package majic.gui.add;

import java.util.List;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.gui.kit.EventThread;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.ProgramServices.SerialPortChoice;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/** Selects one of the serial ports of this computer, or takes one that is typed in. */
final class SerialInput extends AddressInput {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(SerialInput.class);

    private final transient BotType type;
    private final transient Supplier<List<SerialPortChoice>> ports;
    private final JComboBox<Object> port = new JComboBox<>();
    private final JLabel found = new JLabel(" ");
    private @Nullable String wanted;
    private @Nullable String problem;

    SerialInput(BotType type, Supplier<List<SerialPortChoice>> ports) {
        this.type = type;
        this.ports = ports;
        port.setName("serialPort");
        port.setEditable(true);
        JButton again = new JButton(TEXTS.get("lookAgain"));
        again.addActionListener(event -> look());
        add(MajicDialog.label(TEXTS.get("serialPort"), port));
        port.getEditor().getEditorComponent().getAccessibleContext().setAccessibleName(TEXTS.get("serialPort"));
        add(port, "split 2, pushx, wmin 240");
        add(again, "grow 0, wrap");
        add(found, "skip 1");
        addHierarchyListener(event -> EventThread.later(this::reportProblem));
        look();
    }

    @Override
    String address() {
        Object chosen = port.getEditor().getItem();
        String name = chosen instanceof SerialPortChoice known
                ? known.name()
                : String.valueOf(chosen).strip();
        if (chosen == null || name.isEmpty()) {
            throw new BotException(TEXTS.get("serialPort.missing"));
        }
        return type.name() + ":" + name;
    }

    @Override
    boolean fill(BotAddress address) {
        if (!address.scheme().equals(type.name()) || address.rest().contains("//")) {
            return false;
        }
        wanted = address.rest();
        port.setSelectedItem(wanted);
        return true;
    }

    @Override
    String advice() {
        return type.advice();
    }

    /** Lists the ports in the background, because the system may be slow to list them. */
    private void look() {
        found.setText(TEXTS.get("lookingForPorts"));
        EventThread.background(
                "listing serial ports",
                () -> {
                    List<SerialPortChoice> all = ports.get();
                    EventThread.later(() -> show(all));
                },
                this::showProblem);
    }

    private void showProblem(String reason) {
        problem = reason;
        found.setText(TEXTS.get("ports.unknown"));
        reportProblem();
    }

    /** Reports why there is no list, as soon as these fields are those shown. */
    private void reportProblem() {
        if (problem != null && isShowing()) {
            firePropertyChange(PROBLEM, null, problem);
        }
    }

    private void show(List<SerialPortChoice> all) {
        problem = null;
        port.removeAllItems();
        all.forEach(port::addItem);
        if (wanted != null) {
            port.setSelectedItem(wanted);
        }
        found.setText(TEXTS.get("ports", all.size()));
    }
}
