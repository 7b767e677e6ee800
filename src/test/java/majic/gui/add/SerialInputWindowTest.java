package majic.gui.add;

import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Supplier;
import javax.swing.JDialog;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.gui.TestWindow;
import majic.gui.ToyType;
import majic.gui.kit.ProgramServices.SerialPortChoice;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class SerialInputWindowTest {
    private static final String REASON = "native code can be loaded from no folder of this user";

    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final Queue<String> problems = new ConcurrentLinkedQueue<>();
    private SerialInput input;

    private void show(Supplier<List<SerialPortChoice>> ports) {
        BotType type = new ToyType(BotType.Reach.TCP, BotType.Reach.SERIAL);
        window.run(() -> {
            input = new SerialInput(type, ports);
            TwoWayInput ways = new TwoWayInput("Network", new NetworkInput(type), "Serial", input);
            ways.addPropertyChangeListener(
                    AddressInput.PROBLEM, event -> problems.add(String.valueOf(event.getNewValue())));
            JDialog dialog = new JDialog(window.frame());
            dialog.add(ways);
            dialog.pack();
            dialog.setVisible(true);
        });
    }

    @Test
    void theReasonWhyPortsCannotBeListedIsShownWithThem() {
        show(() -> {
            throw new BotException(REASON);
        });
        window.run(() -> input.getParent().getComponent(0).setVisible(false));
        window.run(() -> input.setVisible(true));

        window.await("the reason", () -> problems.contains(REASON));
    }

    @Test
    void theNameThatStaysIsTheAddressOfAPort() {
        String name = "/dev/serial/by-id/usb-FTDI_FT232R_USB_UART_A50285BI-if00-port0";
        show(() -> List.of(new SerialPortChoice(name, name + " – now /dev/ttyUSB0")));
        window.await("the port", () -> {
            try {
                return input.address().equals("toy:" + name);
            } catch (BotException e) {
                return false;
            }
        });
    }
}
