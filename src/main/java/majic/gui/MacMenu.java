package majic.gui;

import com.formdev.flatlaf.util.SystemInfo;
import java.awt.Desktop;

/** The commands of the menu that macOS gives each program. */
final class MacMenu {
    private MacMenu() {}

    /**
     * Lets the commands do what those of the window do: without this, Quit would end the program without asking for
     * scripts that are not saved. A quit that logs the user out is put off, since the program ends by itself
     * afterwards. Has no effect on other systems.
     */
    static void install(Runnable quit, Runnable about) {
        if (!SystemInfo.isMacOS || !Desktop.isDesktopSupported()) {
            return;
        }
        Desktop desktop = Desktop.getDesktop();
        if (desktop.isSupported(Desktop.Action.APP_QUIT_HANDLER)) {
            desktop.setQuitHandler((event, response) -> {
                response.cancelQuit();
                quit.run();
            });
        }
        if (desktop.isSupported(Desktop.Action.APP_ABOUT)) {
            desktop.setAboutHandler(event -> about.run());
        }
    }
}
