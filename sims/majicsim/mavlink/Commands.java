package majicsim.mavlink;

import majicsim.mavlink.message.MessageType;

/** What each command does, and its result (sheet 8). */
final class Commands {
    private static final int FORCE_ARM = 2989;
    private static final int FORCE_DISARM = 21_196;
    private static final int CHANGE_MODE = 1;
    private static final int ABOVE_SEA = 0;
    private static final int ABOVE_SEA_INT = 5;
    private static final long MICROSECOND = 1000;
    private static final double LONGEST_US = 1e10;

    private final Board board;
    private final Vehicle vehicle;
    private final Telemetry telemetry;
    private final Runnable reboot;

    Commands(Vehicle vehicle, Telemetry telemetry, Runnable reboot) {
        this.board = vehicle.board();
        this.vehicle = vehicle;
        this.telemetry = telemetry;
        this.reboot = reboot;
    }

    CommandResult carryOut(Command command, Channel channel) {
        return switch (command.number()) {
            case Command.DO_SET_MODE -> setMode(command);
            case Command.COMPONENT_ARM_DISARM -> armOrDisarm(command);
            case Command.SET_MESSAGE_INTERVAL -> setInterval(command, channel);
            case Command.REQUEST_MESSAGE -> sendOnce(command, channel);
            case Command.DO_REPOSITION -> reposition(command);
            case Command.DO_CHANGE_SPEED -> result(vehicle.speed(command.param2()));
            case Command.NAV_TAKEOFF -> vehicle.takeOff(command.z());
            case Command.NAV_LAND -> change(vehicle.landingMode());
            case Command.NAV_RETURN_TO_LAUNCH -> change(vehicle.returningMode());
            case Command.DO_FLIGHTTERMINATION -> terminate(command);
            case Command.PREFLIGHT_REBOOT -> restart(command);
            default -> CommandResult.UNSUPPORTED;
        };
    }

    private static CommandResult result(boolean isDone) {
        return isDone ? CommandResult.ACCEPTED : CommandResult.FAILED;
    }

    private CommandResult setMode(Command command) {
        boolean isCustom = ((int) command.param1() & Vehicle.CUSTOM) != 0;
        return isCustom ? vehicle.change((int) command.param2()) : CommandResult.DENIED;
    }

    private CommandResult change(int mode) {
        return mode < 0 ? CommandResult.UNSUPPORTED : vehicle.change(mode);
    }

    private CommandResult armOrDisarm(Command command) {
        if (command.param1() == 1) {
            return vehicle.arm(command.param2() == FORCE_ARM);
        }
        return command.param1() == 0 ? vehicle.disarm(command.param2() == FORCE_DISARM) : CommandResult.UNSUPPORTED;
    }

    private CommandResult terminate(Command command) {
        return command.param1() > 0.5 ? vehicle.disarm(true) : CommandResult.FAILED;
    }

    private CommandResult restart(Command command) {
        if (command.param1() != 1) {
            return CommandResult.UNSUPPORTED;
        }
        if (vehicle.isArmed()) {
            return CommandResult.FAILED;
        }
        reboot.run();
        return CommandResult.ACCEPTED;
    }

    private CommandResult setInterval(Command command, Channel channel) {
        MessageType type = MessageType.of((int) command.param1());
        if (type == null || !telemetry.has(type)) {
            return CommandResult.DENIED;
        }
        channel.streams().interval(type, (long) Math.min(command.param2(), LONGEST_US) * MICROSECOND);
        return CommandResult.ACCEPTED;
    }

    private CommandResult sendOnce(Command command, Channel channel) {
        MessageType type = MessageType.of((int) command.param1());
        if (type == null || !telemetry.has(type)) {
            return CommandResult.FAILED;
        }
        channel.streams().once(type);
        return CommandResult.ACCEPTED;
    }

    /** A place in floats would be a metre coarse, so COMMAND_LONG is not taken (sheet 8). */
    private CommandResult reposition(Command command) {
        if (!command.isInt()) {
            return CommandResult.UNSUPPORTED;
        }
        boolean mayChangeMode = ((int) command.param2() & CHANGE_MODE) != 0;
        boolean isGuided = vehicle.mode() == vehicle.guidedMode();
        boolean isPlace = command.x() != 0 || command.y() != 0;
        if (!isPlace || !isGuided && !mayChangeMode) {
            return CommandResult.DENIED;
        }
        if (!isGuided && vehicle.change(vehicle.guidedMode()) != CommandResult.ACCEPTED) {
            return CommandResult.FAILED;
        }
        if (command.param1() > 0) {
            vehicle.speed(command.param1());
        }
        return result(goTo(command.x(), command.y(), command.frame(), command.z()));
    }

    /** Goes to a place on the globe, 1e-7 degrees, whose height is above the sea or above home. */
    boolean goTo(double latitude, double longitude, int frame, double z) {
        if (!Double.isFinite(latitude) || !Double.isFinite(longitude)) {
            return false;
        }
        PositionFilter filter = board.filter();
        boolean isAboveSea = frame == ABOVE_SEA || frame == ABOVE_SEA_INT;
        double height = isAboveSea ? z - PositionFilter.FLOOR_M : z + filter.homeHeight();
        return vehicle.goTo(filter.northOf(latitude), filter.eastOf(longitude), height);
    }
}
