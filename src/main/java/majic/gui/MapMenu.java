package majic.gui;

import java.awt.Window;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.filechooser.FileNameExtensionFilter;
import majic.environment.Settings;
import majic.gui.editor.RecentFiles;
import majic.gui.editor.RecentMenu;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.Mnemonics;
import majic.gui.kit.RobotSelection;
import majic.gui.map.TeamMap;
import majic.nav.CurrentMap;
import majic.nav.grid.NavigationMap;
import majic.script.Session;
import majic.team.Member;
import majic.text.Texts;

/** The menu of the map of the team: each entry submits the command that does it. */
final class MapMenu {
    private static final Texts TEXTS = Texts.of(MapMenu.class);

    private final Window owner;
    private final Session session;
    private final Settings settings;
    private final RobotSelection selection;
    private final CommandChannel channel;
    private final Consumer<String> propose;

    /**
     * Creates the menu.
     *
     * @param propose receives the beginning of a command that the user completes
     */
    MapMenu(
            Window owner,
            Session session,
            Settings settings,
            RobotSelection selection,
            CommandChannel channel,
            Consumer<String> propose) {
        this.owner = owner;
        this.session = session;
        this.settings = settings;
        this.selection = selection;
        this.channel = channel;
        this.propose = propose;
    }

    /**
     * Adds the entries, of which those that make sense at the moment can be chosen.
     *
     * @param teamMap on which waypoints are drawn
     */
    void fill(JMenu menu, TeamMap teamMap) {
        add(
                menu,
                "map.start",
                () -> selection.members().size() == 1,
                () -> channel.submit(
                        "map start " + selection.first().map(Member::number).orElseThrow()));
        add(menu, "map.stop", this::isBuilt, () -> channel.submit("map stop"));
        menu.addSeparator();
        add(menu, "map.open", () -> !isBuilt(), this::chooseAndOpen);
        JMenu recent = new JMenu(TEXTS.get("openRecent"));
        recent.addChangeListener(change -> {
            if (recent.isSelected()) {
                RecentMenu.fill(recent, recentMaps(), this::open);
                Mnemonics.assign(recent);
            }
        });
        menu.add(recent);
        add(menu, "map.save", this::isThere, this::chooseAndSave);
        add(menu, "map.close", () -> isThere() && !isBuilt(), () -> channel.submit("map close"));
        menu.addSeparator();
        add(
                menu,
                "map.localize",
                () -> isThere() && !isBuilt() && !selection.members().isEmpty(),
                () -> channel.submit(selection.numbersInLine() + " localize"));
        JMenu driveTo = new JMenu(TEXTS.get("map.driveTo"));
        driveTo.addChangeListener(change -> {
            if (driveTo.isSelected()) {
                fillPlaces(driveTo);
                Mnemonics.assign(driveTo);
            }
        });
        menu.add(driveTo);
        menu.addChangeListener(change -> driveTo.setEnabled(!selection.members().isEmpty()));
        add(
                menu,
                "map.waypoints",
                () -> teamMap.isShowing() && !selection.members().isEmpty(),
                teamMap::drawWaypoints);
    }

    private void fillPlaces(JMenu menu) {
        menu.removeAll();
        String drive = selection.numbersInLine() + " goto ";
        List<NavigationMap.Place> places =
                map().get().map(NavigationMap::places).orElse(List.of());
        for (NavigationMap.Place place : places) {
            menu.add(place.name()).addActionListener(event -> channel.submit(drive + place.name()));
        }
        if (!places.isEmpty()) {
            menu.addSeparator();
        }
        menu.add(TEXTS.get("map.coordinates")).addActionListener(event -> propose.accept(drive));
    }

    private static void add(JMenu menu, String text, BooleanSupplier makesSense, Runnable action) {
        JMenuItem entry = menu.add(new JMenuItem(TEXTS.get(text)));
        entry.addActionListener(event -> action.run());
        menu.addChangeListener(change -> entry.setEnabled(makesSense.getAsBoolean()));
    }

    private CurrentMap map() {
        return session.map();
    }

    private boolean isThere() {
        return map().get().isPresent();
    }

    private boolean isBuilt() {
        return !map().mappedBy().isEmpty();
    }

    private RecentFiles recentMaps() {
        return new RecentFiles(settings, RecentFiles.MAPS);
    }

    private void chooseAndOpen() {
        FileNameExtensionFilter files = new FileNameExtensionFilter(TEXTS.get("mapFiles"), "yaml", "yml", "map");
        ChooseFile.toOpen(owner, settings, TEXTS.get("map.open.title"), files, this::open);
    }

    private void open(Path file) {
        quotable(file).ifPresentOrElse(channel::showError, () -> {
            recentMaps().add(file);
            channel.submit("map open \"" + file + '"');
        });
    }

    private void chooseAndSave() {
        ChooseFile.toSave(
                owner,
                settings,
                TEXTS.get("map.save.title"),
                "map.yaml",
                file -> file.toString().endsWith(".yaml") ? file : file.resolveSibling(file.getFileName() + ".yaml"),
                file -> quotable(file)
                        .or(() -> AwaitedLine.run(
                                session, String.join(" ", "map", "save", '"' + file.toString() + '"'))));
    }

    /** Why a file cannot be named in a line; empty if it can. */
    private static Optional<String> quotable(Path file) {
        return file.toString().contains("\"") ? Optional.of(TEXTS.get("quotationMark", file)) : Optional.empty();
    }
}
