package majicsim.pioneer.board;

import majicsim.pioneer.devices.Joystick;
import majicsim.pioneer.model.Setting;
import majicsim.pioneer.model.Settings;
import majicsim.pioneer.motion.Drive;

/**
 * Driving by the joystick while its button is held (ARCOS sheet 6.1, JOYDRIVE). With a client connected it must be
 * allowed, and the motors on; without one the button switches them on and off itself.
 */
final class JoyDrive {
    private final Joystick joystick;
    private final Settings settings;
    private final Drive drive;
    private boolean driving;

    JoyDrive(Joystick joystick, Settings settings, Drive drive) {
        this.joystick = joystick;
        this.settings = settings;
        this.drive = drive;
    }

    void step(boolean hasClient) {
        if (joystick.isFiring() && (!hasClient || settings.isOn(Setting.JOYDRIVE))) {
            push(hasClient);
        } else if (driving) {
            release(hasClient);
        }
    }

    private void push(boolean hasClient) {
        if (!driving && !hasClient) {
            drive.enable(true);
        }
        driving = true;
        drive.velocity(joystick.drive() * settings.get(Setting.JOYVEL));
        drive.turnRate(joystick.turn() * settings.get(Setting.JOYRVEL));
    }

    private void release(boolean hasClient) {
        driving = false;
        if (hasClient) {
            drive.halt();
        } else {
            drive.enable(false);
        }
    }
}
