package majic.gui.add;

import java.awt.Window;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import javax.swing.ListSelectionModel;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.gui.kit.DoubleClick;
import majic.gui.kit.EventThread;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.Paragraph;
import majic.gui.kit.ProgramServices.SerialPortChoice;
import majic.link.PortSearch;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/**
 * Searches the networks of this computer for robots: tries the usual port of each type on the neighbouring addresses,
 * and lists the serial ports. Connects to nothing of the team, sends nothing, and ends when it is closed.
 */
final class SearchDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(SearchDialog.class);

    private final transient Places places;
    private final transient List<BotType> types;
    private final DefaultListModel<FoundRobot> found = new DefaultListModel<>();
    private final JList<FoundRobot> list = new JList<>(found);
    private final JProgressBar progress = new JProgressBar();
    private final Paragraph status = new Paragraph("searchStatus", 3, 40);
    private final JButton use;
    private final transient Consumer<String> chosen;
    private transient @Nullable PortSearch search;
    private boolean closed;
    private String serialProblem = "";

    /**
     * Where to search; each is called in the background and may block.
     *
     * @param hosts the hosts to try
     * @param spared the places of the robots of the team, which are not tried
     * @param serialPorts the serial ports of this computer
     * @param senders what the robots of a type are that send to this computer unasked, by their addresses
     */
    record Places(
            Supplier<List<InetAddress>> hosts,
            Supplier<Set<InetSocketAddress>> spared,
            Supplier<List<SerialPortChoice>> serialPorts,
            Function<BotType, Map<String, String>> senders) {
        Places(
                Supplier<List<InetAddress>> hosts,
                Supplier<Set<InetSocketAddress>> spared,
                Supplier<List<SerialPortChoice>> serialPorts) {
            this(hosts, spared, serialPorts, type -> Map.of());
        }
    }

    /**
     * Creates the dialog and starts the search.
     *
     * @param chosen receives the address that was chosen
     */
    SearchDialog(Window owner, List<BotType> types, Places places, Consumer<String> chosen) {
        super(owner, TEXTS.get("searchNetwork"));
        this.types = types;
        this.places = places;
        this.chosen = chosen;
        use = button(TEXTS.get("use"), this::choose);
        use.setEnabled(false);
        fill(content(), use, closing(TEXTS.get("close")));
        EventThread.background("searching for robots", this::search, reason -> end(reason, true));
    }

    private JPanel content() {
        list.setName("foundRobots");
        list.getAccessibleContext().setAccessibleName(TEXTS.get("places"));
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.addListSelectionListener(event -> use.setEnabled(!list.isSelectionEmpty()));
        list.addMouseListener(new DoubleClick(this::choose));
        progress.setName("searchProgress");
        progress.setIndeterminate(true);
        progress.getAccessibleContext().setAccessibleName(TEXTS.get("progress"));
        status.setFocusable(true);
        status.show(TEXTS.get("looking"), false);
        JScrollPane scroll = new JScrollPane(list);
        JPanel panel = new JPanel(new MigLayout("insets 0, gap 8 8, wrap 1", "[560, grow, fill]", "[][][grow, fill]"));
        panel.add(status, "wmin 300"); // the least width decides the height of the dialog
        panel.add(progress, "h 6!");
        panel.add(scroll, "h 180");
        return panel;
    }

    private void search() {
        List<SerialPortChoice> serial = serialPorts();
        EventThread.later(() -> types.stream()
                .filter(type -> type.reaches().contains(BotType.Reach.SERIAL))
                .forEach(type -> serial.forEach(port -> add(FoundRobot.at(port, type)))));
        EventThread.background("listening for robots", () -> types.forEach(this::listen), reason -> {});
        List<InetAddress> hosts = places.hosts().get();
        Set<InetSocketAddress> spared = places.spared().get();
        Map<Integer, BotType> ports = new TreeMap<>();
        types.stream().filter(type -> port(type) > 0).forEach(type -> ports.put(port(type), type));
        PortSearch made = new PortSearch(hosts, ports.keySet(), spared, new Results(ports));
        EventThread.later(() -> begin(made, hosts, ports.values()));
    }

    /** A port that another program uses is left out. */
    private void listen(BotType type) {
        Map<String, String> senders;
        try {
            senders = places.senders().apply(type);
        } catch (BotException e) {
            return;
        }
        EventThread.later(() -> senders.forEach((address, kind) -> add(FoundRobot.sending(address, kind, type))));
    }

    /** The network is searched all the same if the serial ports cannot be listed. */
    private List<SerialPortChoice> serialPorts() {
        try {
            return places.serialPorts().get();
        } catch (BotException e) {
            EventThread.later(() -> serialProblem = String.valueOf(e.getMessage()));
            return List.of();
        }
    }

    private static int port(BotType type) {
        return type.defaultPort(type.name());
    }

    private void begin(PortSearch made, Collection<InetAddress> hosts, Collection<BotType> sought) {
        if (closed) {
            made.close();
            return;
        }
        if (hosts.isEmpty()) {
            end(TEXTS.get("noNetwork"), false);
            return;
        }
        search = made;
        String ports = sought.stream()
                .map(type -> port(type) + " (" + type.label() + ")")
                .collect(Collectors.joining(", "));
        status.show(TEXTS.get("trying", ports, PortSearch.networks(hosts)), false);
        made.start();
    }

    private void add(FoundRobot robot) {
        found.addElement(robot);
    }

    private void showProgress(int tried, int all) {
        progress.setIndeterminate(false);
        progress.setMaximum(Math.max(1, all));
        progress.setValue(tried);
        if (tried == all) {
            end(TEXTS.get(found.isEmpty() ? "nothingFound" : "searchEnded"), false);
        }
    }

    private void end(String words, boolean wrong) {
        progress.setIndeterminate(false);
        progress.setValue(progress.getMaximum());
        status.show(serialProblem.isEmpty() ? words : words + " " + serialProblem, wrong || !serialProblem.isEmpty());
    }

    private void choose() {
        FoundRobot robot = list.getSelectedValue();
        if (robot != null) {
            dispose();
            chosen.accept(robot.address());
        }
    }

    /** Ends the search. */
    @Override
    public void dispose() {
        closed = true;
        if (search != null) {
            search.close();
        }
        super.dispose();
    }

    /** Passes the results on to the event dispatch thread. */
    private final class Results implements PortSearch.Listener {
        private final Map<Integer, BotType> ports;

        Results(Map<Integer, BotType> ports) {
            this.ports = ports;
        }

        @Override
        public void found(InetSocketAddress place) {
            BotType type = ports.get(place.getPort());
            if (type != null) {
                EventThread.later(() -> add(FoundRobot.at(place, type)));
            }
        }

        @Override
        public void progress(int tried, int all) {
            EventThread.later(() -> showProgress(tried, all));
        }
    }
}
