package majic.gui.bots;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.stream.Stream;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.UIManager;
import majic.gui.acts.RunningAct;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.NumberBadge;
import majic.gui.kit.Palette;
import majic.gui.plot.PlottedPanel;
import majic.panel.BatteryIcon;
import majic.panel.DrawingColors;
import majic.panel.PlotLink;
import majic.team.Member;
import majic.team.Team;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/**
 * One robot of the team: number, type, state, act, battery and connection, with the buttons that stop and reconnect it.
 * Listens to the robot until {@link #close()}.
 */
final class RobotCard extends PlottedPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(RobotCard.class);
    private static final int ARC = 10;

    private final transient Team team;
    private final transient Member member;
    private final transient CardReader reader;
    private final transient RobotActions actions;
    private final transient RunningAct act;
    private final transient LinkMeter link = new LinkMeter();
    private final transient MemberRefresh refresh;
    private final JLabel badge = new JLabel();
    private final JLabel name;
    private final JLabel line;
    private final JLabel activity;
    private final JLabel actTime;
    private final JLabel connection = new JLabel();
    private final JLabel battery = new JLabel();
    private final JButton reconnect;
    private final JButton stop;
    private @Nullable CardSize size;
    private transient @Nullable RobotSummary shown;
    private boolean selected;

    RobotCard(Team team, Member member, RobotActions actions, CardReader reader) {
        super(null, actions.plots(), member.number(), member.bot()::parameters);
        this.team = team;
        this.member = member;
        this.reader = reader;
        this.actions = actions;
        act = new RunningAct(member);
        int number = member.number();
        setName("card" + number);
        setOpaque(false);
        name = new NamedLabel("cardName" + number, "");
        name.putClientProperty("FlatLaf.style", "font: bold");
        line = new NamedLabel("cardLine" + number, "");
        activity = new NamedLabel("cardActivity" + number, "");
        actTime = new NamedLabel("cardActTime" + number, "");
        battery.setName("cardBattery" + number);
        stop = button("cardStop" + number, TEXTS.get("card.stop"), ActionIcon.STOP, TEXTS.get("card.stop.tip", number));
        stop.addActionListener(event -> actions.stop(member));
        reconnect = button(
                "cardReconnect" + number,
                TEXTS.get("card.reconnect"),
                ActionIcon.RECONNECT,
                TEXTS.get("card.reconnect.tip", number));
        reconnect.addActionListener(event -> {
            reconnect.setEnabled(false);
            actions.reconnect(member, () -> reconnect.setEnabled(true));
        });
        PlotLink.install(
                battery,
                List.of(),
                point -> List.of(reader.readings(member).battery().parameter()));
        show(CardSize.FULL);
        update();
        refresh = new MemberRefresh(member, this::update);
    }

    private static JButton button(String name, String text, Icon icon, String tip) {
        JButton button = new JButton(text, icon);
        button.setName(name);
        button.setFocusable(false);
        button.setIconTextGap(UIScale.scale(3));
        button.setToolTipText(tip);
        button.getAccessibleContext().setAccessibleName(tip);
        return button;
    }

    Member member() {
        return member;
    }

    /** Schedules an update; callable from any thread. */
    void changed() {
        refresh.changed();
    }

    /** Removes the listener. */
    void close() {
        refresh.close();
    }

    /** Shows whether the robot is selected. */
    void setSelected(boolean isSelected) {
        selected = isSelected;
        describe();
        repaint();
    }

    boolean isSelected() {
        return selected;
    }

    /** Arranges the parts for another size. */
    void show(CardSize newSize) {
        if (newSize == size) {
            return;
        }
        size = newSize;
        removeAll();
        adapt(newSize);
        switch (newSize) {
            case FULL -> addThreeLines();
            case MEDIUM -> addTwoLines();
            case COMPACT -> addOneLine("insets 0 6 0 3", 6);
            case NARROW -> addOneLine("insets 0 3 0 2", 3);
            case BADGE -> {
                arrange("insets 0 3 0 2", "[grow]");
                add(badge);
                add(line, "wmin 0, gapleft 3");
            }
        }
        if (newSize != CardSize.BADGE) {
            int gap = newSize == CardSize.NARROW ? 2 : 4;
            Stream.of(reconnect, stop).forEach(button -> add(button, "hmin 18, hmax 100%, gapleft " + gap));
        }
        shown = null;
        update();
    }

    /** An act's name is cut where there is no room for all of it, its time is not. */
    private void addThreeLines() {
        arrange("insets 4 8 4 6", "[grow][grow][grow]");
        add(badge, "spany 3, aligny center");
        add(name, "spanx 3, wmin 0, gapleft 8");
        add(line, "newline, wmin 0, gapleft 8");
        addMeters();
        add(activity, "newline, spanx 3, split 4, wmin 0, growx 0, gapleft 8");
        add(actTime, "growx, pushx, gapleft 5");
    }

    private void addTwoLines() {
        arrange("insets 3 8 3 6", "[grow][grow]");
        add(badge, "spany 2, aligny center");
        add(name, "wmin 0, gapleft 8");
        addMeters();
        add(line, "newline, spanx 3, split 3, wmin 0, growx, pushx, gapleft 8");
    }

    private void addOneLine(String insets, int gap) {
        arrange(insets, "[grow]");
        add(badge);
        add(line, "wmin 0, gapleft " + gap);
        add(connection, "gapleft 4");
        add(battery, "gapleft 4");
    }

    /** Gives the parts the texts and margins that a size has room for. */
    private void adapt(CardSize newSize) {
        stop.setText(newSize == CardSize.FULL ? TEXTS.get("card.stop") : "");
        reconnect.setText(newSize == CardSize.FULL ? TEXTS.get("card.reconnect") : "");
        int side = newSize == CardSize.NARROW ? 2 : 5;
        Stream.of(stop, reconnect).forEach(button -> button.setMargin(new Insets(1, side, 1, side)));
        badge.setIcon(new NumberBadge(member.number(), isOneLine(newSize) ? 18 : 26));
        line.setIconTextGap(newSize == CardSize.NARROW ? 3 : 4);
    }

    private void arrange(String insets, String rows) {
        setLayout(new MigLayout(insets + ", gap 0, hidemode 3, novisualpadding", "[][grow, fill][][][][]", rows));
    }

    private void addMeters() {
        add(connection, "gapleft 6");
        add(battery, "gapleft 6");
    }

    /** Shows the state of the robot. */
    void update() {
        RobotSummary now = RobotSummary.of(member, team.stopStatus(), act, link, reader.readings(member), countdown());
        if (now.equals(shown)) {
            return;
        }
        shown = now;
        name.setText(now.name());
        line.setIcon(now.icon());
        line.setText(
                switch (Objects.requireNonNull(size)) {
                    case FULL -> now.problem().isEmpty() ? now.condition() : now.problem();
                    case MEDIUM -> now.line();
                    case COMPACT, NARROW -> now.shortest();
                    case BADGE -> "";
                });
        line.putClientProperty("FlatLaf.style", now.problem().isEmpty() ? null : "font: bold");
        line.setForeground(now.isUnconfirmed() || now.isLost() ? Palette.error() : null);
        activity.setText(now.activity());
        actTime.setText(now.actTime());
        connection.setIcon(new LinkIcon(now.bars()));
        connection.setVisible(!now.isLost() && (size != CardSize.NARROW || now.bars() < LinkMeter.MOST_BARS));
        battery.setIcon(new BatteryIcon(now.battery().percent(), false));
        battery.setText(
                isOneLine(size) || !now.problem().isEmpty() ? "" : now.battery().text());
        battery.setVisible(showsBattery(now));
        reconnect.setVisible(now.isLost());
        describe();
        repaint();
    }

    private static boolean isOneLine(@Nullable CardSize size) {
        return size == CardSize.COMPACT || size == CardSize.NARROW || size == CardSize.BADGE;
    }

    /** A card of one line has no room for a voltage, and a narrow one only for a warning. */
    private boolean showsBattery(RobotSummary now) {
        OptionalInt percent = now.battery().percent();
        if (now.isLost() || (isOneLine(size) && percent.isEmpty())) {
            return false;
        }
        return size == CardSize.NARROW
                ? percent.orElseThrow() < BatteryIcon.LOW_PERCENT
                : !now.battery().text().isEmpty();
    }

    private String countdown() {
        return actions.attempts(member).map(ReconnectCountdown::shortText).orElse("");
    }

    private void describe() {
        if (shown == null) {
            return;
        }
        setToolTipText(member.number() + " " + shown.description());
        getAccessibleContext()
                .setAccessibleName(
                        selected
                                ? TEXTS.get("card.name.selected", member.number(), shown.description())
                                : TEXTS.get("card.name", member.number(), shown.description()));
    }

    /** Adapts the colours to the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (stop != null) {
            shown = null;
            update();
        }
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(0, 0);
    }

    /**
     * Paints the card: tinted with a thick frame if selected, framed in the alarm colour if a stop is not confirmed.
     */
    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        DrawingColors.prepare(g);
        boolean alarm = shown != null && shown.isUnconfirmed();
        Color accent = UIManager.getColor("Component.accentColor");
        double inset = selected || alarm ? 1 : 0.5;
        RoundRectangle2D shape =
                new RoundRectangle2D.Double(inset, inset, getWidth() - 2 * inset, getHeight() - 2 * inset, ARC, ARC);
        g.setColor(selected ? DrawingColors.translucent(accent, 0.16) : Palette.paper());
        g.fill(shape);
        g.setStroke(new BasicStroke(selected || alarm ? 2 : 1));
        g.setColor(edge(alarm, accent));
        g.draw(shape);
        if (isFocusOwner()) {
            g.setColor(Palette.text());
            g.setStroke(new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, new float[] {2, 2}, 0));
            g.draw(new RoundRectangle2D.Double(3.5, 3.5, getWidth() - 7, getHeight() - 7, ARC / 2.0, ARC / 2.0));
        }
        g.dispose();
    }

    private Color edge(boolean alarm, Color accent) {
        if (alarm) {
            return Palette.error();
        }
        return selected ? Palette.mixed(Palette.text(), accent, 0.5) : UIManager.getColor("Component.borderColor");
    }
}
