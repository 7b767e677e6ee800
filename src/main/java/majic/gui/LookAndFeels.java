package majic.gui;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import com.formdev.flatlaf.util.SystemInfo;
import java.awt.Font;
import java.awt.Window;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.UIManager;
import majic.environment.Settings;
import majic.gui.kit.BackgroundSettings;
import majic.gui.kit.EventThread;
import majic.gui.kit.PlainTextUi;

/** Installs the light or the dark look and feel in a text size, and stores what is chosen. */
final class LookAndFeels {
    private static final String KEY = "window.look";
    private static final String DARK = "dark";
    private static final String LIGHT = "light";
    private static final String SIZE = "window.textSize";
    private static final int NORMAL = 100;

    /** The text sizes to choose from, percent. */
    static final List<Integer> TEXT_SIZES = List.of(NORMAL, 125, 150);

    private static boolean installed;

    private LookAndFeels() {}

    static {
        Map<String, String> changed = new HashMap<>();
        // FlatLaf would read Java's style sheet for HTML to set the colour of links there, which delays the window.
        changed.put("Component.linkColor", "null");
        if (SystemInfo.isLinux) {
            // The names that FlatLaf tries first are searched in all fonts of the computer where they are not
            // installed.
            FlatLaf.setPreferredMonospacedFontFamily(Font.MONOSPACED);
            changed.put("semibold.font", "bold");
        }
        FlatLaf.setGlobalExtraDefaults(changed);
    }

    /**
     * Installs the look and feel and the text size that were chosen last; must be called before the first component is
     * created.
     */
    static void install(Settings settings) {
        set(settings.get(KEY).equals(Optional.of(DARK)));
        PlainTextUi.install();
        int percent = textSize(settings);
        if (percent != NORMAL) {
            setTextSize(percent);
        }
    }

    /** Returns the text size that was chosen last, percent. */
    static int textSize(Settings settings) {
        return settings.get(SIZE)
                .filter(text -> TEXT_SIZES.stream().anyMatch(size -> text.equals("" + size)))
                .map(Integer::valueOf)
                .orElse(NORMAL);
    }

    /** Changes the text size of all windows, in pieces, and stores the choice. */
    static void changeTextSize(int percent, Settings settings) {
        change(() -> setTextSize(percent));
        BackgroundSettings.put(settings, SIZE, "" + percent);
    }

    /** Changes the defaults, then in further pieces the components of all windows. */
    private static void change(Runnable defaults) {
        EventThread.piece(() -> {
            defaults.run();
            Stream.of(Window.getWindows()).forEach(ComponentUpdate::begin);
        });
    }

    /** Every other font follows the default one. */
    private static void setTextSize(int percent) {
        Font usual = UIManager.getLookAndFeelDefaults().getFont("defaultFont");
        UIManager.put("defaultFont", percent == NORMAL ? null : usual.deriveFont(usual.getSize2D() * percent / 100));
    }

    /** Loads both looks and updates all windows at once, without storing a choice. */
    static void rehearse() {
        for (boolean dark : List.of(true, false)) {
            set(dark);
            FlatLaf.updateUI();
        }
    }

    /** Changes the look and feel of all windows, in pieces, and stores the choice. */
    static void change(boolean dark, Settings settings) {
        change(() -> set(dark));
        BackgroundSettings.put(settings, KEY, dark ? DARK : LIGHT);
    }

    /** Has no effect if that look and feel is installed already. */
    private static void set(boolean dark) {
        // Asking the UIManager before it has one would make it build Java's own look and feel first.
        if (installed && UIManager.getLookAndFeel() instanceof FlatLaf && FlatLaf.isLafDark() == dark) {
            return;
        }
        installed = true;
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
    }
}
