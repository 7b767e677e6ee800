package majic.hemisson.panel;

import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.event.MouseEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import javax.swing.JPanel;
import majic.hemisson.readings.Proximity;
import majic.panel.DrawingColors;
import majic.panel.PlotLink;
import majic.text.NumberText;
import majic.text.Texts;

/**
 * The robot from above, its front upward, as large as fits: its body, around it the bars of its sensors over the light
 * on them, and on it the LEDs and the buzzer to click. For the event thread.
 */
final class HemissonDrawing extends JPanel {
    private static final long serialVersionUID = 1;

    /** From the middle to beyond the figures, mm. */
    private static final double SHOWN_MM = 124;

    private static final double LED_MM = 5;
    private static final double WHEEL_REACH_MM = 12;

    /** The parameters of the left and of the right motor. */
    static final List<String> WHEELS = List.of("speedLeft", "speedRight");

    private static final double LEAST_LED_PX = 3.5;
    private static final int LEAST_CLICK_PX = 16;
    private static final Texts TEXTS = Texts.of(HemissonDrawing.class);

    private final transient LedSwitch ledSwitch;
    private final transient List<LedButton> buttons;
    private transient HemissonScene view;

    HemissonDrawing(HemissonScene view, LedSwitch ledSwitch) {
        super(null);
        this.view = view;
        this.ledSwitch = ledSwitch;
        this.buttons = Arrays.stream(LedOrBuzzer.values()).map(LedButton::new).toList();
        setName("robot");
        setOpaque(false);
        getAccessibleContext().setAccessibleName(TEXTS.get("drawing"));
        setToolTipText("");
        PlotLink.install(this, List.of(), this::readingsAt);
        buttons.forEach(button -> {
            button.addActionListener(click -> toggle(button.part()));
            add(button);
        });
    }

    /** Shows another moment; on the event dispatch thread. */
    void show(HemissonScene newView) {
        view = newView;
        for (LedButton button : buttons) {
            LedOrBuzzer part = button.part();
            button.show(part.isOn(newView), ledSwitch.isWaiting(part), view.isConnected());
        }
        repaint();
    }

    private void toggle(LedOrBuzzer part) {
        ledSwitch.toggle(part);
        buttons.stream()
                .filter(button -> button.part() == part)
                .forEach(button -> button.show(button.isOn(), ledSwitch.isWaiting(part), view.isConnected()));
    }

    private double pxPerMm() {
        return Math.min(getWidth(), getHeight()) / (2 * SHOWN_MM);
    }

    @Override
    public void doLayout() {
        double scale = pxPerMm();
        double radius = Math.max(LEAST_LED_PX, LED_MM * scale);
        int side = (int) Math.max(LEAST_CLICK_PX, 4 * radius);
        for (LedButton button : buttons) {
            LedOrBuzzer part = button.part();
            double x = getWidth() / 2.0 - part.yMm() * scale;
            double y = getHeight() / 2.0 - part.xMm() * scale;
            button.scale(radius);
            button.setBounds((int) Math.round(x - side / 2.0), (int) Math.round(y - side / 2.0), side, side);
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D screen = (Graphics2D) graphics.create();
        DrawingColors.prepare(screen);
        screen.translate(getWidth() / 2.0, getHeight() / 2.0);
        double scale = pxPerMm();
        DrawingColors colors = view.isConnected()
                ? DrawingColors.current()
                : DrawingColors.current().faded();
        BarsDrawing bars = new BarsDrawing(view, colors, scale);
        Graphics2D robot = (Graphics2D) screen.create();
        robot.transform(onScreen(scale));
        List<Integer> light = view.light();
        new HemissonBodyDrawing(view, colors, scale).paint(robot);
        if (light != null && view.isConnected()) {
            LightDrawing.paint(robot, light, colors, scale);
        }
        bars.paintBars(robot);
        robot.dispose();
        bars.paintFigures(screen);
        paintSpeed(screen, colors, HemissonBodyDrawing.WHEEL_Y_MM, view.wheels().left());
        paintSpeed(
                screen, colors, -HemissonBodyDrawing.WHEEL_Y_MM, view.wheels().right());
        screen.dispose();
    }

    /** The value of the motor, behind its wheel. */
    private void paintSpeed(Graphics2D screen, DrawingColors colors, double y, int value) {
        String text = NumberText.signed(value);
        FontMetrics metrics = screen.getFontMetrics();
        int width = metrics.stringWidth(text);
        double foot = HemissonBodyDrawing.WHEEL_HALF_MM * pxPerMm() + metrics.getAscent();
        double centre = HemissonBodyDrawing.insideHull(y * pxPerMm(), width, foot, pxPerMm());
        screen.setColor(colors.line());
        screen.drawString(text, (float) (-centre - width / 2.0), (float) foot);
    }

    private static AffineTransform onScreen(double scale) {
        return new AffineTransform(0, -scale, -scale, 0, 0, 0);
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        double scale = pxPerMm();
        Point2D at = new Point2D.Double(
                (getHeight() / 2.0 - event.getY()) / scale, (getWidth() / 2.0 - event.getX()) / scale);
        for (int sensor = 0; sensor < Proximity.SENSORS; sensor++) {
            SensorDrawing mount = SensorDrawing.ALL.get(sensor);
            if (mount.along(mount.lengthMm() / 2).distance(at) < mount.lengthMm() / 2) {
                return words(mount, sensor);
            }
        }
        return TEXTS.get("drawing.tip");
    }

    /** Returns the parameters whose values are drawn at a point: of a sensor, or of the wheels. */
    private List<String> readingsAt(Point point) {
        double scale = pxPerMm();
        Point2D at = new Point2D.Double((getHeight() / 2.0 - point.y) / scale, (getWidth() / 2.0 - point.x) / scale);
        for (int sensor = 0; sensor < Proximity.SENSORS; sensor++) {
            SensorDrawing mount = SensorDrawing.ALL.get(sensor);
            double reach = mount.lengthMm() / 2 + (mount.looksDown() ? 0 : BarsDrawing.FIGURE_MM);
            if (mount.along(reach).distance(at) < reach) {
                return List.of("prox" + sensor);
            }
        }
        boolean atWheel = Math.abs(Math.abs(at.getY()) - HemissonBodyDrawing.WHEEL_Y_MM) < WHEEL_REACH_MM
                && Math.abs(at.getX()) < 2 * HemissonBodyDrawing.WHEEL_HALF_MM;
        if (!atWheel) {
            return List.of();
        }
        return List.of(WHEELS.get(at.getY() > 0 ? 0 : 1));
    }

    private String words(SensorDrawing mount, int sensor) {
        Proximity seen = view.seen();
        List<Integer> light = view.light();
        String text = seen == null ? TEXTS.get("proximity.none", mount.words()) : words(mount, sensor, seen);
        return light == null ? text : TEXTS.get("light", text, light.get(sensor));
    }

    private String words(SensorDrawing mount, int sensor, Proximity seen) {
        OptionalDouble mm = mount.looksDown() ? OptionalDouble.empty() : seen.distanceMm(sensor);
        return mm.isPresent()
                ? TEXTS.get("proximity.mm", mount.words(), view.proximity(sensor), Math.round(mm.getAsDouble()))
                : TEXTS.get("proximity", mount.words(), view.proximity(sensor));
    }
}
