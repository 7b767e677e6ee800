package majic.gui;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.GridBagLayout;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import majic.gui.kit.Paragraph;
import majic.gui.kit.ScrolledPanel;
import majic.gui.kit.StyledLabel;
import majic.team.StopStatus;
import majic.team.Team;
import majic.team.TeamListener;
import majic.text.ErrorWords;
import majic.text.NumberList;
import majic.text.Texts;

/**
 * The strip above the messages that names the robots whose stop was not confirmed, each with its reason, and what to
 * do, and why STOP has not reached other desks. Hidden while there is neither. It takes its room from the messages
 * alone, so that nothing that can be clicked moves when it appears or goes.
 */
final class StopAlarm extends JPanel implements TeamListener {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(StopAlarm.class);
    private static final Color RED = new Color(0xB3261E);
    private static final int GAP = 12;

    private final transient Team team;
    private final JScrollPane messages;
    private final JLabel title = new StyledLabel("stopAlarm", "", Font.BOLD, 2);
    private final Paragraph reasons = new Paragraph("stopReasons", 0, 0);
    private final Paragraph remedy = new Paragraph("stopRemedy", 0, 0);
    private final JButton again = new JButton(TEXTS.get("stopAgain"));

    /**
     * Places the strip.
     *
     * @param messages the area of the messages, above which it is shown
     */
    StopAlarm(Team team, JScrollPane messages) {
        super(new BorderLayout(GAP, 0));
        this.team = team;
        this.messages = messages;
        setBackground(RED);
        setBorder(BorderFactory.createEmptyBorder(4, GAP, 4, GAP));
        again.setName("stopAgain");
        again.setRequestFocusEnabled(false);
        again.setToolTipText(TEXTS.get("stopAgain.tip"));
        again.addActionListener(event -> stopAgain());
        remedy.setText(TEXTS.get("remedy"));
        JPanel wrapped = new ScrolledPanel(new BorderLayout());
        wrapped.setOpaque(false);
        wrapped.add(reasons, BorderLayout.NORTH);
        wrapped.add(remedy, BorderLayout.CENTER);
        JScrollPane rest = new JScrollPane(
                wrapped, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        rest.setBorder(BorderFactory.createEmptyBorder());
        rest.setOpaque(false);
        rest.getViewport().setOpaque(false);
        JPanel texts = new JPanel(new BorderLayout());
        texts.setOpaque(false);
        texts.add(title, BorderLayout.NORTH);
        texts.add(rest, BorderLayout.CENTER);
        JPanel button = new JPanel(new GridBagLayout());
        button.setOpaque(false);
        button.add(again);
        add(texts, BorderLayout.CENTER);
        add(button, BorderLayout.EAST);
        messages.setColumnHeaderView(this);
        messages.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                wrap();
            }
        });
        title.setForeground(Color.WHITE);
        reasons.keepColor(Color.WHITE);
        remedy.keepColor(Color.WHITE);
        showRobots();
    }

    @Override
    public void stopStatusChanged(StopStatus then) {
        showRobots();
    }

    private void showRobots() {
        StopStatus status = team.stopStatus();
        Map<Integer, String> unconfirmed = status.unconfirmed();
        String elsewhere = status.elsewhere();
        setVisible(!unconfirmed.isEmpty() || !elsewhere.isEmpty());
        again.setVisible(!unconfirmed.isEmpty());
        remedy.setVisible(!unconfirmed.isEmpty());
        title.setText(
                unconfirmed.isEmpty()
                        ? TEXTS.get("notElsewhere")
                        : TEXTS.get(
                                "unconfirmed", unconfirmed.size(), NumberList.of(List.copyOf(unconfirmed.keySet()))));
        reasons.setText(Stream.of(reasons(unconfirmed), ErrorWords.of(elsewhere))
                .filter(text -> !text.isEmpty())
                .collect(Collectors.joining("   ")));
        wrap();
    }

    /** Gives the texts the height that they have at the present width. */
    private void wrap() {
        int width = messages.getWidth() - again.getPreferredSize().width - 5 * GAP;
        Stream.of(reasons, remedy).forEach(text -> text.setSize(Math.max(width, 1), Short.MAX_VALUE));
        revalidate();
    }

    /** No higher than the area of the messages; the reasons scroll then. */
    @Override
    public Dimension getPreferredSize() {
        int height = Math.min(super.getPreferredSize().height, messages.getHeight());
        return new Dimension(0, isVisible() ? height : 0);
    }

    private void stopAgain() {
        Map<Integer, String> unconfirmed = team.stopStatus().unconfirmed();
        team.stop(
                team.members().stream()
                        .filter(member -> unconfirmed.containsKey(member.number()))
                        .toList(),
                null);
    }

    /** Names each reason once, with the robots that it holds for. */
    static String reasons(Map<Integer, String> unconfirmed) {
        Map<String, List<Integer>> robots = new LinkedHashMap<>();
        unconfirmed.forEach((robot, reason) ->
                robots.computeIfAbsent(reason, key -> new ArrayList<>()).add(robot));
        List<String> texts = new ArrayList<>();
        robots.forEach((reason, which) -> texts.add(NumberList.of(which) + ": " + ErrorWords.of(reason)));
        return String.join("   ", texts);
    }
}
