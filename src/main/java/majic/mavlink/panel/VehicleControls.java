package majic.mavlink.panel;

import java.awt.Insets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JPanel;
import majic.bot.BotCommand;
import majic.bot.MajicBot;
import majic.bot.Reading;
import majic.panel.CommandHost;
import majic.panel.ReadingText;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/**
 * The mode of the autopilot, and a button for each command of the vehicle that needs no argument. Each submits a line
 * as if it had been typed, so that the rules of owners and STOP hold. For the event dispatch thread.
 */
final class VehicleControls extends JPanel {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(VehicleControls.class);

    /** The commands with a button, in the order of the buttons, and the keys of their tool tips. */
    private static final Map<String, String> BUTTONS = new LinkedHashMap<>();

    static {
        BUTTONS.put("hold", "hold.tip");
        BUTTONS.put("land", "land.tip");
        BUTTONS.put("surface", "surface.tip");
        BUTTONS.put("home", "home.tip");
        BUTTONS.put("arm", "arm.tip");
        BUTTONS.put("disarm", "disarm.tip");
    }

    /** Three buttons fit into the width of the readings. */
    private static final Insets NARROW = new Insets(2, 3, 2, 3);

    private final ModeButton mode = new ModeButton(name -> submit("set mode " + name));
    private final transient Map<String, JButton> buttons = new LinkedHashMap<>();

    VehicleControls() {
        super(new MigLayout(
                "insets 0, fillx, wrap 3, gap 4 4, novisualpadding",
                "[grow, fill, sg, 40::][grow, fill, sg, 40::][grow, fill, sg, 40::]"));
        setOpaque(false);
        add(mode, "span 3, wmin 0");
    }

    private void submit(String command) {
        CommandHost.of(this).ifPresent(host -> host.submitCommand(command));
    }

    void show(MajicBot bot, List<String> modes) {
        Set<String> commands = bot.commands().stream().map(BotCommand::name).collect(Collectors.toSet());
        List<String> wanted =
                BUTTONS.keySet().stream().filter(commands::contains).toList();
        if (bot.isConnected() && !wanted.equals(List.copyOf(buttons.keySet()))) {
            replaceButtons(wanted);
        }
        boolean usable = bot.isConnected() && CommandHost.of(this).isPresent();
        Reading reading = bot.reading("mode");
        mode.show(ReadingText.of(bot.isConnected() ? reading.value() : reading.last()), modes);
        mode.setEnabled(usable && !modes.isEmpty());
        buttons.values().forEach(button -> button.setEnabled(usable));
    }

    private void replaceButtons(List<String> commands) {
        buttons.values().forEach(this::remove);
        buttons.clear();
        for (String command : commands) {
            JButton button = new JButton(TEXTS.get(command));
            button.setName(command);
            button.setMargin(NARROW);
            button.setToolTipText(TEXTS.get(BUTTONS.getOrDefault(command, command)));
            button.addActionListener(event -> submit(command));
            buttons.put(command, button);
            button.putClientProperty("JButton.minimumWidth", 0);
            add(button);
        }
        revalidate();
    }
}
