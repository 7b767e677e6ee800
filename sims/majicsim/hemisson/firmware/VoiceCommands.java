package majicsim.hemisson.firmware;

import java.util.Arrays;
import majicsim.hemisson.modules.I2cBus;
import majicsim.hemisson.modules.ModuleKind;
import majicsim.hemisson.modules.Voice;
import majicsim.hemisson.uart.Reply;

/** The text-to-speech module's commands in the RoadNarrows dialect: {@code A,T,...}. */
final class VoiceCommands implements ModuleCommandSet {
    private static final int ADDRESS = ModuleKind.SPEECH.address();
    private static final int LONGEST_TEXT = 72;
    private static final int MOST = 7;

    private final I2cBus bus;
    private int volume;
    private int pitch = 3;
    private int rate = 3;

    VoiceCommands(I2cBus bus) {
        this.bus = bus;
    }

    @Override
    public Reply answer(char command, String argument) throws ErrorReplyException {
        switch (command) {
            case 'S' -> speak(argument);
            case 'C' -> phrase(argument);
            case 'G' -> volume = Arguments.decimal(argument, 0, MOST);
            case 'P' -> pitch = Arguments.decimal(argument, 0, MOST);
            case 'R' -> rate = Arguments.decimal(argument, 0, MOST);
            case 'Q' -> {
                return Reply.of(isBusy() ? ",1" : ",0");
            }
            case 'V' -> {
                return Reply.of("," + Arguments.hex2(bus.read(ADDRESS, Voice.VERSION_REGISTER, 0)));
            }
            default -> throw new ErrorReplyException(ErrorReply.UNKNOWN_MODULE_COMMAND);
        }
        return Reply.of("," + argument);
    }

    private void speak(String text) throws ErrorReplyException {
        if (text.isEmpty() || text.length() > LONGEST_TEXT) {
            throw new ErrorReplyException(ErrorReply.LENGTH);
        }
        refuseWhileBusy();
        int[] bytes = Arrays.copyOf(new int[] {0, volume, rate, pitch}, text.length() + 5);
        for (int i = 0; i < text.length(); i++) {
            bytes[i + 4] = text.charAt(i);
        }
        bus.write(ADDRESS, Voice.COMMAND, bytes);
        bus.write(ADDRESS, Voice.COMMAND, Voice.SPEAK);
    }

    private void phrase(String argument) throws ErrorReplyException {
        int phrase = Arguments.decimal(argument, 1, Voice.PHRASES);
        refuseWhileBusy();
        bus.write(ADDRESS, Voice.COMMAND, phrase);
    }

    private void refuseWhileBusy() throws ErrorReplyException {
        if (isBusy()) {
            throw new ErrorReplyException(ErrorReply.BUSY);
        }
    }

    private boolean isBusy() {
        return bus.read(ADDRESS, Voice.COMMAND, 0) == Voice.BUSY;
    }
}
