package majic.gui.plot;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JToggleButton;
import javax.swing.LayoutFocusTraversalPolicy;
import javax.swing.Timer;
import majic.environment.Settings;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.CloseKey;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.Mnemonics;
import majic.gui.plot.data.Span;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** A window with one plot. Must be used on the event dispatch thread. */
final class PlotWindow extends JFrame {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(PlotWindow.class);
    private static final int VALUES_MS = 250;
    private static final int LEAST_WIDTH = 520;
    private static final int LEAST_HEIGHT = 260;

    /** Pictures in files have twice the resolution of a usual screen. */
    private static final double FILE_SCALE = 2;

    private static final int MOST_IN_TITLE = 4;

    private final transient PlotModel model;
    private final transient Settings settings;
    private final PlotView view;
    private final CurveList curves;
    private final transient KeptComputations kept;
    private transient List<Curve> computed = List.of();
    private final Timer values;
    private final JToggleButton pause = new JToggleButton(TEXTS.get("pause"));
    private final JButton compute = button("compute", TEXTS.get("compute.button"), TEXTS.get("compute.hint"));
    private final JButton reset = button("showNewest", TEXTS.get("newest"), TEXTS.get("newest.hint"));

    /**
     * Creates a window, not yet visible.
     *
     * @param settings keep the folder of the last file
     * @param stop stops all robots
     */
    PlotWindow(PlotModel model, Settings settings, JComponent stop) {
        HelpTopic.set(getRootPane(), "plots");
        CloseKey.install(this);
        this.model = model;
        this.settings = settings;
        kept = new KeptComputations(settings);
        view = new PlotView(model);
        curves = new CurveList(model);
        values = new Timer(VALUES_MS, tick -> curves.update());
        setName("plot");
        setDefaultCloseOperation(DISPOSE_ON_CLOSE);
        JPanel content = new JPanel(new BorderLayout());
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        JPanel tools = tools(stop, screen.width);
        content.add(tools, BorderLayout.NORTH);
        content.add(view, BorderLayout.CENTER);
        content.add(side(), BorderLayout.EAST);
        setContentPane(content);
        Mnemonics.assign(content);
        getRootPane().setTransferHandler(new ReadingDrop(model));
        setMinimumSize(new Dimension(
                Math.max(UIScale.scale(LEAST_WIDTH), tools.getPreferredSize().width), UIScale.scale(LEAST_HEIGHT)));
        pack();
        setSize(Math.min(getWidth(), screen.width), Math.min(getHeight(), screen.height));
        model.addListener(this::modelChanged);
        modelChanged();
        values.start();
        setFocusTraversalPolicy(new ChartFirst());
    }

    PlotModel model() {
        return model;
    }

    /** Places the buttons in one row, or in two if the screen is too narrow for that, with STOP at the end. */
    private JPanel tools(JComponent stop, int screenWidth) {
        JPanel tools = new JPanel(new MigLayout("insets 6 8 4 8, gap 12 4", "[][grow, fill][]"));
        JPanel choices = choices();
        JPanel actions = actions();
        tools.add(choices, "cell 0 0");
        tools.add(actions, "cell 1 0");
        tools.add(stop, "cell 2 0, growy, wmin pref");
        if (tools.getPreferredSize().width > screenWidth) {
            tools.add(actions, "cell 0 1 2 1");
            tools.add(stop, "cell 2 0 1 2, growy, wmin pref");
        }
        return tools;
    }

    private JPanel choices() {
        JPanel choices = new JPanel(new MigLayout("insets 0, gap 6", "[]12[][][][]"));
        JButton add = button("addCurves", TEXTS.get("add"), TEXTS.get("add.hint"));
        add.addActionListener(event -> addCurves());
        choices.add(add);
        ButtonGroup lengths = new ButtonGroup();
        for (TimeLength length : TimeLength.values()) {
            choices.add(lengthButton(length, lengths));
        }
        return choices;
    }

    private JPanel actions() {
        JPanel actions = new JPanel(new MigLayout("insets 0, gap 6", "[][]12:push[][]"));
        pause.setName("pause");
        pause.setToolTipText(TEXTS.get("pause.hint"));
        pause.addActionListener(event -> model.pause(pause.isSelected()));
        reset.addActionListener(event -> model.zoom(null));
        actions.add(pause);
        actions.add(reset);
        JButton png = button("savePng", TEXTS.get("png.button"), TEXTS.get("png.hint"));
        png.addActionListener(event -> savePng());
        JButton csv = button("saveCsv", TEXTS.get("csv.button"), TEXTS.get("csv.hint"));
        csv.addActionListener(event -> saveCsv());
        actions.add(png);
        actions.add(csv);
        return actions;
    }

    private static JButton button(String name, String text, String tip) {
        JButton button = new JButton(text);
        button.setName(name);
        button.setToolTipText(tip);
        return button;
    }

    private JToggleButton lengthButton(TimeLength length, ButtonGroup group) {
        JToggleButton button = new JToggleButton(length.text(), length == model.length());
        button.setName(length.name());
        button.setToolTipText(TEXTS.get("length.hint"));
        button.addActionListener(event -> model.show(length));
        group.add(button);
        return button;
    }

    private JComponent side() {
        JScrollPane scroll = new JScrollPane(
                curves, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setPreferredSize(new Dimension(UIScale.scale(290), 200));
        compute.addActionListener(event -> new ComputeCurveDialog(this, model).setVisible(true));
        JPanel below = new JPanel(new MigLayout("insets 4 10 8 8"));
        below.add(compute);
        JPanel side = new JPanel(new BorderLayout());
        side.add(scroll, BorderLayout.CENTER);
        side.add(below, BorderLayout.SOUTH);
        return side;
    }

    /** Adds the computed curves that the plot of these readings had last. */
    void restoreComputed() {
        kept.restore(model);
    }

    private void keepComputed() {
        List<Curve> now = model.curves().stream().filter(Curve::isComputed).toList();
        if (!now.equals(computed)) {
            computed = now;
            kept.keep(model);
        }
    }

    private void modelChanged() {
        keepComputed();
        reset.setEnabled(model.isZoomed());
        compute.setEnabled(ComputeCurveDialog.operands(model).findAny().isPresent());
        pause.setSelected(model.isPaused());
        setTitle(title(model.curves()));
    }

    private String title(List<Curve> curves) {
        String names = curves.stream()
                .limit(MOST_IN_TITLE)
                .map(curve -> curve.quantity().title())
                .collect(Collectors.joining(", "));
        String shown = curves.size() > MOST_IN_TITLE ? names + ", …" : names;
        if (model.source().isReplay()) {
            return names.isEmpty() ? TEXTS.get("title.replay") : TEXTS.get("title.replay.of", shown);
        }
        return names.isEmpty() ? TEXTS.get("title") : TEXTS.get("title.of", shown);
    }

    void addCurves() {
        new AddCurvesDialog(this, model).setVisible(true);
    }

    private void savePng() {
        ChartJob job = ChartJob.of(model, view.getWidth(), view.getHeight(), FILE_SCALE, true);
        ChooseFile.toSave(this, settings, TEXTS.get("png"), "plot.png", file -> PlotExport.png(job, file));
    }

    private void saveCsv() {
        List<Curve> saved = model.curves();
        Span time = model.time();
        ChooseFile.toSave(this, settings, TEXTS.get("csv"), "plot.csv", file -> PlotExport.csv(saved, time, file));
    }

    @Override
    public void dispose() {
        values.stop();
        model.close();
        super.dispose();
    }

    /** Gives the chart the focus at first. */
    private final class ChartFirst extends LayoutFocusTraversalPolicy {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getDefaultComponent(Container window) {
            return view;
        }
    }
}
