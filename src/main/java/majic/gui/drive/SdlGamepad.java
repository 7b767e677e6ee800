package majic.gui.drive;

import com.studiohartman.jamepad.Configuration;
import com.studiohartman.jamepad.ControllerManager;
import com.studiohartman.jamepad.ControllerState;
import java.io.IOException;
import java.util.stream.IntStream;
import majic.bot.BotException;
import majic.file.NativeFolder;
import majic.text.ErrorWords;
import majic.text.Texts;

/** Reads game controllers by the library Jamepad, which brings native code. A shoulder button must be held to drive. */
public final class SdlGamepad implements Gamepad {
    private static final Texts TEXTS = Texts.of(SdlGamepad.class);

    private static final int MOST_CONTROLLERS = 4;
    private static final String MAPPINGS = "/majic/gui/drive/controllers.txt";

    private final ControllerManager controllers;

    private SdlGamepad(ControllerManager controllers) {
        this.controllers = controllers;
    }

    /**
     * Loads the native code; blocks.
     *
     * @throws BotException if there is none for this computer
     */
    public static Gamepad open() {
        try {
            ControllerManager controllers =
                    NativeFolder.load(() -> new ControllerManager(new Configuration(), MAPPINGS));
            controllers.initSDLGamepad();
            return new SdlGamepad(controllers);
        } catch (IOException | RuntimeException | LinkageError e) {
            throw new BotException(TEXTS.get("gamepad.none", ErrorWords.of(String.valueOf(e.getMessage()))), e);
        }
    }

    @Override
    public GamepadState read() {
        return IntStream.range(0, MOST_CONTROLLERS)
                .mapToObj(controllers::getState)
                .filter(state -> state.isConnected)
                .findFirst()
                .map(SdlGamepad::state)
                .orElse(GamepadState.UNPLUGGED);
    }

    private static GamepadState state(ControllerState now) {
        return GamepadState.of(now.lb || now.rb, -now.leftStickY, -now.leftStickX);
    }

    @Override
    public void close() {
        controllers.quitSDLGamepad();
    }
}
