package majic.panel.map;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import javax.swing.JPanel;
import javax.swing.UIManager;
import majic.bot.Pose;
import majic.panel.DrawingColors;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * A floor with a grid and a scale bar. Follows a robot if there is one to follow, shows everything, or shows the area
 * chosen with mouse, keys or buttons. The wheel zooms, dragging moves, a double click shows everything. On a small map
 * the buttons are hidden; wheel and keys still work. Must be used on the event dispatch thread.
 */
public class ZoomableMap extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int TOOLS_INSET = 6;
    private static final Texts TEXTS = Texts.of(ZoomableMap.class);

    private final transient MapContent content;
    private final transient @Nullable RobotContent followed;
    private final MapTools tools;
    private Mode mode;
    private double zoom = 1;
    private boolean aheadUp;
    private transient MapView chosen = new MapView(1, 0, 0, MapView.Y_UP, 1, 1);

    /** Determines which area is visible. */
    enum Mode {
        /** The robot stays in the middle. */
        FOLLOW,
        /** Everything is visible. */
        FIT,
        /** The area was chosen by the user. */
        FREE
    }

    /**
     * Creates a map that follows a robot.
     *
     * @param content the content of the map
     */
    public ZoomableMap(RobotContent content) {
        this(content, content, Mode.FOLLOW);
    }

    /**
     * Creates a map that shows everything.
     *
     * @param content the content of the map
     */
    public ZoomableMap(MapContent content) {
        this(content, null, Mode.FIT);
    }

    private ZoomableMap(MapContent content, @Nullable RobotContent followed, Mode mode) {
        super(null);
        this.content = content;
        this.followed = followed;
        this.mode = mode;
        setName("map");
        setFocusable(true);
        setToolTipText("");
        getAccessibleContext().setAccessibleName(TEXTS.get("map"));
        tools = new MapTools(this);
        add(tools);
        MapMouse mouse = new MapMouse(this);
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        addFocusListener(new Frame());
        MapAction.bindKeys(this);
    }

    /**
     * Returns the present mapping of the floor to the component.
     *
     * @return the view at the present size
     */
    public final MapView view() {
        int width = Math.max(1, getWidth());
        int height = Math.max(1, getHeight());
        return switch (mode) {
            case FIT -> everything(width, height);
            case FREE -> chosen.sized(width, height);
            case FOLLOW -> followed == null ? everything(width, height) : around(followed, width, height);
        };
    }

    /**
     * Returns the view that fits everything between the buttons and the text at the bottom, which would hide a part of
     * it.
     */
    private MapView everything(int width, int height) {
        int head = tools.isVisible() ? tools.getHeight() : 0;
        int foot = content.footPx(width);
        int free = Math.max(height / 2, height - head - foot);
        return MapView.fitting(content.extent(), width, free)
                .sized(width, height)
                .moved(0, (head - foot) / 2.0);
    }

    private MapView around(RobotContent robot, int width, int height) {
        Pose pose = robot.pose();
        double scale = robot.nearPxPerMm(Math.min(width, height)) * zoom;
        return new MapView(scale, pose.xMm(), pose.yMm(), aheadUp ? pose.headingDeg() : MapView.Y_UP, width, height);
    }

    /** Returns whether there is one robot that the map can follow. */
    boolean hasRobot() {
        return followed != null;
    }

    boolean follows() {
        return mode == Mode.FOLLOW;
    }

    boolean hasAheadUp() {
        return follows() && aheadUp;
    }

    /** Shows everything from now on, until another area is chosen. */
    public final void fit() {
        become(Mode.FIT);
    }

    void toggleFollow() {
        if (follows()) {
            choose(view());
        } else {
            zoom = 1;
            become(Mode.FOLLOW);
        }
    }

    void toggleAheadUp() {
        aheadUp = !hasAheadUp();
        become(Mode.FOLLOW);
    }

    /** Removes the trails and echoes shown so far. */
    public final void clear() {
        content.clear();
        repaint();
    }

    /** Scales the view by a factor; a map that follows continues to follow. */
    void zoom(double factor, double x, double y) {
        if (follows()) {
            double now = view().pxPerMm();
            MapView zoomed = view().zoomed(factor, x, y);
            zoom *= zoomed.pxPerMm() / now;
            repaint();
        } else {
            choose(view().zoomed(factor, x, y));
        }
    }

    void zoom(double factor) {
        zoom(factor, getWidth() / 2.0, getHeight() / 2.0);
    }

    void drag(double rightPx, double downPx) {
        choose(view().moved(rightPx, downPx));
    }

    private void choose(MapView view) {
        chosen = view;
        become(Mode.FREE);
    }

    private void become(Mode newMode) {
        mode = newMode;
        tools.showState();
        repaint();
    }

    @Override
    public void doLayout() {
        Rectangle wanted = new Rectangle(new java.awt.Point(TOOLS_INSET, TOOLS_INSET), tools.getPreferredSize());
        boolean fits = getWidth() >= wanted.width + 2 * TOOLS_INSET && getHeight() >= 4 * wanted.height;
        tools.setVisible(fits);
        tools.setBounds(wanted);
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        Point2D place = view().place(event.getX(), event.getY());
        return content.tip(place.getX(), place.getY(), view());
    }

    /** Returns the colour of the floor in the present look and feel. */
    static Color floor() {
        Color floor = UIManager.getColor("TextArea.background");
        return floor == null ? Color.WHITE : floor;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors.prepare(pen);
        pen.setColor(floor());
        pen.fillRect(0, 0, getWidth(), getHeight());
        MapView view = view();
        MapGrid grid = new MapGrid(pen, view, DrawingColors.current());
        grid.paintLines();
        Graphics2D inside = (Graphics2D) pen.create();
        content.paint(inside, view);
        inside.dispose();
        grid.paintScale(floor());
        paintFrame(pen);
        pen.dispose();
    }

    /** Fills the four edges; a rectangle drawn with smooth edges is blurred and computed for the whole area. */
    private void paintFrame(Graphics2D pen) {
        boolean focused = isFocusOwner();
        Color color = UIManager.getColor(focused ? "Component.focusedBorderColor" : "Component.borderColor");
        int width = focused ? 2 : 1;
        pen.setColor(color == null ? Color.GRAY : color);
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
        pen.fillRect(0, 0, getWidth(), width);
        pen.fillRect(0, getHeight() - width, getWidth(), width);
        pen.fillRect(0, 0, width, getHeight());
        pen.fillRect(getWidth() - width, 0, width, getHeight());
    }

    /** Shows by the border whether the map has the focus. */
    private final class Frame implements FocusListener {
        @Override
        public void focusGained(FocusEvent event) {
            repaint();
        }

        @Override
        public void focusLost(FocusEvent event) {
            repaint();
        }
    }
}
