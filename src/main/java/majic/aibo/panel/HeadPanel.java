package majic.aibo.panel;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import javax.swing.JPanel;
import majic.aibo.body.Joint;
import majic.aibo.body.SensorReadings;
import majic.bot.MajicBot;
import majic.panel.SetpointSlider;
import majic.team.Member;
import majic.text.NumberText;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/**
 * Sliders that turn the head. They move the dog, so they are refused while a script or an act owns it or STOP is
 * active. For the event thread.
 */
final class HeadPanel extends JPanel {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(HeadPanel.class);

    private final transient MajicBot bot;
    private final transient SensorReadings senses;
    private final transient SliderControl control;
    private final transient Map<Joint, SetpointSlider> sliders = new EnumMap<>(Joint.class);

    HeadPanel(MajicBot bot, SensorReadings senses) {
        super(new MigLayout("insets 0, wrap 1, fillx, gap 0 1, novisualpadding", "[grow, fill]"));
        this.bot = bot;
        this.senses = senses;
        this.control = new SliderControl(bot);
        setOpaque(false);
        add(Joint.HEAD_PAN, TEXTS.get("headPan"));
        add(Joint.HEAD_TILT, TEXTS.get("headTilt"));
        add(Joint.NECK, TEXTS.get("neck"));
        SetpointSlider.align(sliders.values());
    }

    private void add(Joint joint, String label) {
        boolean turns = joint == Joint.HEAD_PAN;
        String name = joint.urbiName();
        SetpointSlider slider =
                new SetpointSlider(bot.parameter(name), turns, (degrees, last) -> control.choose(name, degrees, last));
        sliders.put(joint, slider.labelled(label));
        add(slider);
    }

    private static String words(Optional<Double> degrees) {
        return degrees.map(measured -> NumberText.of(Math.round(measured)) + "°")
                .orElse("–");
    }

    void refresh() {
        boolean usable = bot.isConnected() && Member.of(bot).isPresent();
        sliders.forEach((joint, slider) -> {
            slider.setEnabled(usable);
            slider.setCurrent(bot.isConnected());
            slider.show(
                    words(senses.number(joint.sensor())),
                    senses.number(joint.sensor()).orElse(null),
                    control.isHolding());
        });
    }
}
