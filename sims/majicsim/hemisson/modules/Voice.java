package majicsim.hemisson.modules;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Text to speech: register 00 takes a stored phrase (1 to 30), or a text and then the word to speak it; it reads FF
 * meanwhile.
 */
public final class Voice implements I2cModule {
    public static final int COMMAND = 0x00;
    public static final int VERSION_REGISTER = 0x01;
    public static final int SPEAK = 0x40;
    public static final int PHRASES = 30;
    public static final int BUSY = 0xFF;

    private static final int VERSION = 7;
    private static final int TEXT_BEGINS = 4;
    private static final double SECONDS_A_CHARACTER = 0.08;
    private static final double SECONDS_A_PHRASE = 1.5;
    private static final int REMEMBERED = 100;

    private final List<String> said = new ArrayList<>();
    private String loaded = "";
    private double leftSeconds;

    @Override
    public ModuleKind kind() {
        return ModuleKind.SPEECH;
    }

    @Override
    public int read(int register, int index) {
        return switch (register + index) {
            case COMMAND -> leftSeconds > 0 ? BUSY : 0;
            case VERSION_REGISTER -> VERSION;
            default -> 0;
        };
    }

    /** A write that begins with 00 loads volume, speed, pitch and text; any other first byte is a command. */
    @Override
    public void write(int register, int[] bytes) {
        if (register != COMMAND || leftSeconds > 0) {
            return;
        }
        int first = bytes[0];
        if (first == 0) {
            loaded = text(bytes);
        } else if (first == SPEAK) {
            say(loaded, loaded.length() * SECONDS_A_CHARACTER);
        } else if (first <= PHRASES) {
            say("phrase " + first, SECONDS_A_PHRASE);
        }
    }

    @Override
    public boolean isIdle() {
        return leftSeconds <= 0;
    }

    @Override
    public void step(double seconds) {
        leftSeconds = Math.max(0, leftSeconds - seconds);
    }

    /** The spoken texts, oldest first; stored phrases as "phrase 1" and so on. */
    public List<String> said() {
        return List.copyOf(said);
    }

    private void say(String text, double seconds) {
        said.add(text);
        if (said.size() > REMEMBERED) {
            said.remove(0);
        }
        leftSeconds = seconds;
    }

    private static String text(int[] bytes) {
        int end = TEXT_BEGINS;
        while (end < bytes.length && bytes[end] != 0) {
            end++;
        }
        byte[] latin1 = new byte[Math.max(0, Math.min(end, bytes.length) - TEXT_BEGINS)];
        for (int i = 0; i < latin1.length; i++) {
            latin1[i] = (byte) bytes[TEXT_BEGINS + i];
        }
        return new String(latin1, StandardCharsets.ISO_8859_1);
    }
}
