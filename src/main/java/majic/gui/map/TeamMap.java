package majic.gui.map;

import java.awt.Dimension;
import majic.panel.map.ZoomableMap;

/**
 * The bird's-eye view of the team: every robot with its number, heading and trail, and with a lab the room and where
 * the robots really are. Shows everything by itself until somebody zooms or drags; a double click goes back to that.
 */
public final class TeamMap extends ZoomableMap {
    private static final long serialVersionUID = 1L;

    private final transient TeamFloor floor;

    public TeamMap() {
        this(new TeamFloor());
    }

    private TeamMap(TeamFloor floor) {
        super(floor);
        this.floor = floor;
        setName("teamMap");
        setPreferredSize(new Dimension(640, 420));
        setMinimumSize(new Dimension(240, 160));
        getAccessibleContext().setAccessibleName("Team map");
    }

    /** Shows another moment. */
    public void show(MapScene scene) {
        floor.show(scene);
        repaint();
    }

    public MapScene scene() {
        return floor.scene();
    }
}
