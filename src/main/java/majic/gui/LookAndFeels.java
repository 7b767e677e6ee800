package majic.gui;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import com.formdev.flatlaf.util.SystemInfo;
import java.awt.Font;
import java.util.Optional;
import javax.swing.UIManager;
import majic.bot.BotException;
import majic.bot.Settings;
import majic.gui.kit.EventThread;

/** Installs the light or the dark look and feel, and stores which one is chosen. */
final class LookAndFeels {
    private static final String KEY = "window.look";
    private static final String DARK = "dark";
    private static final String LIGHT = "light";

    private LookAndFeels() {}

    static {
        if (SystemInfo.isLinux) {
            // The names that FlatLaf tries first are searched in all fonts of the computer where they are not
            // installed.
            FlatLaf.setPreferredMonospacedFontFamily(Font.MONOSPACED);
        }
    }

    /** Installs the look and feel that was chosen last; must be called before the first component is created. */
    static void install(Settings settings) {
        set(settings.get(KEY).equals(Optional.of(DARK)));
    }

    /** Changes the look and feel of all windows at once, and stores the choice. */
    static void change(boolean dark, Settings settings) {
        set(dark);
        FlatLaf.updateUI();
        EventThread.background("remembering the look", () -> remember(dark, settings));
    }

    /** Has no effect if that look and feel is installed already. */
    private static void set(boolean dark) {
        if (UIManager.getLookAndFeel() instanceof FlatLaf && FlatLaf.isLafDark() == dark) {
            return;
        }
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
    }

    private static void remember(boolean dark, Settings settings) {
        try {
            settings.put(KEY, dark ? DARK : LIGHT);
        } catch (BotException e) {
            System.getLogger(LookAndFeels.class.getName())
                    .log(System.Logger.Level.DEBUG, "the look is not remembered after the end", e);
        }
    }
}
