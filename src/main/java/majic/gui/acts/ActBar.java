package majic.gui.acts;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import javax.swing.UIManager;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.Palette;
import majic.team.Member;
import majic.team.Owner;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Shows the act that runs on a robot: its name, its time, its last message, and the button that ends it. */
public final class ActBar extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ActBar.class);
    private static final int TICK_MS = 200;
    private static final int ARC = 12;

    private final transient RunningAct act;
    private final JLabel name;
    private final JLabel time = new JLabel();
    private final JLabel message;
    private final Timer tick = new Timer(TICK_MS, event -> update());

    /**
     * Creates a bar that is invisible until an act runs.
     *
     * @param end ends the act
     */
    public ActBar(Member member, Runnable end) {
        super(new MigLayout("insets 4 10 4 8, gap 10 0", "[][][grow, fill][]"));
        act = new RunningAct(member);
        setOpaque(false);
        name = new NamedLabel("act" + member.number(), "");
        name.putClientProperty("FlatLaf.style", "font: bold");
        time.setName("actTime" + member.number());
        time.setToolTipText(TEXTS.get("time"));
        message = new NamedLabel("actSaid" + member.number(), "");
        JButton off = new JButton(TEXTS.get("endAct"));
        off.setName("endAct" + member.number());
        off.setToolTipText(TEXTS.get("endAct.hint"));
        off.setFocusable(false);
        off.addActionListener(event -> end.run());
        add(name, "wmin 40");
        add(time);
        add(message, "wmin 0");
        add(off);
        setVisible(false);
    }

    /** Shows the act that runs now. */
    public void update() {
        Optional<Owner> owner = act.now();
        setVisible(owner.isPresent());
        if (owner.isPresent() && isDisplayable()) {
            tick.start();
        } else {
            tick.stop();
        }
        owner.ifPresent(this::show);
    }

    private void show(Owner owner) {
        name.setText(owner.name());
        time.setText(act.time());
        time.setForeground(Palette.faint());
        message.setText(owner.status().isEmpty() ? " " : owner.status());
        message.setToolTipText(owner.status().isEmpty() ? null : owner.status());
    }

    /** Continues to update when the bar was moved to another place. */
    @Override
    public void addNotify() {
        super.addNotify();
        update();
    }

    @Override
    public void removeNotify() {
        tick.stop();
        super.removeNotify();
    }

    /** Paints a tinted background, so that a running act is visible from a distance. */
    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        Color accent = UIManager.getColor("Component.accentColor");
        g.setColor(new Color(accent.getRed(), accent.getGreen(), accent.getBlue(), 40));
        g.fillRoundRect(0, 0, getWidth(), getHeight(), ARC, ARC);
        g.dispose();
    }
}
