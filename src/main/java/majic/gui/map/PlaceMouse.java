package majic.gui.map;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.Consumer;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.SwingUtilities;
import majic.bot.Pose;
import majic.gui.kit.CommandChannel;
import majic.nav.Destination;
import majic.nav.grid.NavigationMap.Place;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * Changes the places with names on the map: with Shift, dragging one moves it; a right click on one offers to rename or
 * remove it, and a right click on the floor to name a place there. Both offer to drive there. Each is a command; where
 * a name is to be typed, it is put into the command line. Must be used on the event dispatch thread.
 */
final class PlaceMouse extends MouseAdapter {
    private static final Texts TEXTS = Texts.of(PlaceMouse.class);

    /** Is replaced by what is typed. */
    private static final String NAME = "NAME";

    private static final int DRAG_PX = 4;

    private final TeamMap map;
    private final DriveMouse drive;
    private final CommandChannel channel;
    private final Consumer<String> propose;
    private @Nullable Place dragged;
    private Point pressed = new Point();

    /**
     * Creates the mouse listener; it must also be added for mouse motions.
     *
     * @param drive sends robots to places
     * @param propose receives a command whose word {@value #NAME} is to be replaced by the user
     */
    PlaceMouse(TeamMap map, DriveMouse drive, CommandChannel channel, Consumer<String> propose) {
        this.map = map;
        this.drive = drive;
        this.channel = channel;
        this.propose = propose;
    }

    @Override
    public void mousePressed(MouseEvent event) {
        dragged = null;
        pressed = event.getPoint();
        boolean robot = map.topRobotAt(pressed).isPresent();
        if (!robot && SwingUtilities.isLeftMouseButton(event) && event.isShiftDown()) {
            dragged = map.placeAt(pressed).orElse(null);
        }
        openMenu(event);
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (dragged != null) {
            map.previewPlace(moved(dragged, event));
        }
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        Place ended = dragged;
        dragged = null;
        if (ended != null) {
            map.previewPlace(null);
            if (map.contains(event.getPoint()) && event.getPoint().distance(pressed) > DRAG_PX) {
                Place there = moved(ended, event);
                channel.submit("map place " + there.name() + " " + new Destination(there));
            }
        }
        openMenu(event);
    }

    private Place moved(Place place, MouseEvent event) {
        Pose at = map.view().pose(event.getPoint());
        Pose pose = new Pose(at.xMm(), at.yMm(), place.pose().headingDeg());
        return new Place(place.name(), pose, place.withHeading());
    }

    private void openMenu(MouseEvent event) {
        if (event.isPopupTrigger() && map.topRobotAt(event.getPoint()).isEmpty()) {
            JPopupMenu menu = new JPopupMenu();
            map.placeAt(event.getPoint())
                    .ifPresentOrElse(place -> addOfPlace(menu, place), () -> addOfFloor(menu, event));
            if (menu.getComponentCount() > 0) {
                menu.show(map, event.getX(), event.getY());
            }
        }
    }

    private void addOfPlace(JPopupMenu menu, Place place) {
        String name = place.name();
        if (drive.hasRobots()) {
            add(menu, "driveToPlace", TEXTS.get("driveTo", name), () -> drive.drive(place));
        }
        add(menu, "renamePlace", TEXTS.get("rename", name), () -> propose("map place " + name + " as " + NAME));
        add(menu, "removePlace", TEXTS.get("remove", name), () -> channel.submit("map place " + name + " off"));
    }

    private void addOfFloor(JPopupMenu menu, MouseEvent event) {
        Pose here = map.view().pose(event.getPoint());
        if (drive.hasRobots()) {
            add(menu, "driveHere", TEXTS.get("driveHere"), () -> drive.drive(here));
        }
        if (map.hasPicture()) {
            String at = new Destination(here, false).toString();
            add(menu, "namePlace", TEXTS.get("name"), () -> propose("map place " + NAME + " " + at));
        }
    }

    private void propose(String command) {
        propose.accept(command);
    }

    private static void add(JPopupMenu menu, String name, String text, Runnable action) {
        JMenuItem entry = menu.add(new JMenuItem(text));
        entry.setName(name);
        entry.addActionListener(event -> action.run());
    }
}
