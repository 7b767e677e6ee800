package majicsim.hemisson.firmware;

import majicsim.hemisson.modules.I2cBus;
import majicsim.hemisson.modules.LinearCamera;
import majicsim.hemisson.modules.ModuleKind;
import majicsim.hemisson.uart.Reply;

/** The linear camera's commands in the RoadNarrows dialect: {@code A,L,...}. */
final class CameraCommands implements ModuleCommandSet {
    private static final int ZONES = 3;
    private static final int ZONE_PIXELS = LinearCamera.PIXEL_COUNT / ZONES;

    private final I2cBus bus;

    CameraCommands(I2cBus bus) {
        this.bus = bus;
    }

    @Override
    public Reply answer(char command, String argument) throws ErrorReplyException {
        return switch (command) {
            case 'P' -> pixels(LinearCamera.PIXELS, argument);
            case 'Q' -> pixels(LinearCamera.THRESHOLDED, argument);
            case 'E' -> set(LinearCamera.EXPOSURE, argument);
            case 'F' -> get(LinearCamera.EXPOSURE);
            case 'T' -> set(LinearCamera.THRESHOLD, argument);
            case 'U' -> get(LinearCamera.THRESHOLD);
            case 'L' -> led(argument);
            case 'V' -> get(LinearCamera.VERSION_REGISTER);
            default -> throw new ErrorReplyException(ErrorReply.UNKNOWN_MODULE_COMMAND);
        };
    }

    /** Zone 0 is all, 1 to 3 a third each. */
    private Reply pixels(int register, String argument) throws ErrorReplyException {
        int zone = Arguments.decimal(argument, 0, ZONES);
        int from = zone == 0 ? 0 : (zone - 1) * ZONE_PIXELS;
        int end = zone == 0 ? LinearCamera.PIXEL_COUNT : from + ZONE_PIXELS;
        StringBuilder reply = new StringBuilder("," + zone + ",");
        for (int i = from; i < end; i++) {
            reply.append(Arguments.hex2(bus.read(ModuleKind.CAMERA.address(), register, i)));
        }
        return Reply.of(reply.toString());
    }

    private Reply set(int register, String argument) throws ErrorReplyException {
        bus.write(ModuleKind.CAMERA.address(), register, Arguments.hex(argument, 2));
        return Reply.of("," + argument);
    }

    private Reply get(int register) {
        return Reply.of("," + Arguments.hex2(bus.read(ModuleKind.CAMERA.address(), register, 0)));
    }

    private Reply led(String argument) throws ErrorReplyException {
        int on = Arguments.decimal(argument, 0, 1);
        bus.write(ModuleKind.CAMERA.address(), LinearCamera.LED, on);
        return Reply.of("," + argument);
    }
}
