package majicsim.pioneer;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * Reads a CONFIG packet field by field as the sheet lists them (10), written apart from the encoder it tests.
 *
 * @param numbers the number fields that were there, by the sheet's names
 * @param texts the string fields that were there, by the sheet's names
 */
public record ConfigView(Map<String, Integer> numbers, Map<String, String> texts) {
    /** s string, B ubyte, b byte, U uint, i int, L uint32; in the sheet's order. */
    private static final String FIELDS = """
            s CLASS, s SUBCLASS, s SERNUM, B 4MOTS, U ROTVELTOP, U TRANSVELTOP, U ROTACCTOP, U TRANSACCTOP, U PWMMAX, s NAME,
            B SIPCYCLE, B HOSTBAUD, B AUX1BAUD, U GRIPPER, U FRONTSONAR, B REARSONAR, U LOWBATTERY, U REVCOUNT, U WATCHDOG,
            B P2MPACS, U STALLVAL, U STALLCOUNT, U JOYVEL, U JOYRVEL, U ROTVELMAX, U TRANSVELMAX, U ROTACC, U ROTDECEL,
            U ROTKP, U ROTKV, U ROTKI, U TRANSACC, U TRANSDECEL, U TRANSKP, U TRANSKV, U TRANSKI, B FRONTBUMPS, B REARBUMPS,
            B CHARGER, B SONARCYCLE, B AUTOBAUD, B HASGYRO, i DRIFTFACTOR, B AUX2BAUD, B AUX3BAUD, U TICKSMM, U SHUTDOWN,
            s VERSION, U GYROCW, U GYROCCW, B KINEMATICSDELAY, U LATVELTOP, U LATACCTOP, U LATVELMAX, U LATACC, U LATDECEL,
            U CHARGETHRESHOLD, B PDBPORT, U GYRORATELIMIT, b HIGHTEMP, U POWERBITS, B BATTERYTYPE, U LOWSOC, U SHUTDOWNSOC,
            s BOOTLOADER, L FLAGS, i GYROFIRMWARE""";

    private static final List<String> IN_ORDER =
            Pattern.compile(",\\s+").splitAsStream(FIELDS).toList();

    static ConfigView of(byte[] packet) {
        Reader reader = new Reader(packet);
        ConfigView view = new ConfigView(new LinkedHashMap<>(), new LinkedHashMap<>());
        for (String field : IN_ORDER) {
            if (reader.at < packet.length - 2) {
                view.read(field.charAt(0), field.substring(2), reader);
            }
        }
        if (reader.at != packet.length - 2) {
            throw new AssertionError("CONFIG does not end with a field");
        }
        return view;
    }

    public int number(String field) {
        return numbers.get(field);
    }

    int fieldCount() {
        return numbers.size() + texts.size();
    }

    private void read(char type, String name, Reader reader) {
        switch (type) {
            case 's' -> texts.put(name, reader.text());
            case 'B' -> numbers.put(name, reader.number(1));
            case 'b' -> numbers.put(name, (int) (byte) reader.number(1));
            case 'U' -> numbers.put(name, reader.number(2));
            case 'i' -> numbers.put(name, (int) (short) reader.number(2));
            default -> numbers.put(name, reader.number(4));
        }
    }

    private static final class Reader {
        private final byte[] packet;
        private int at = 4;

        Reader(byte[] packet) {
            this.packet = packet;
        }

        int number(int bytes) {
            int value = 0;
            for (int i = 0; i < bytes; i++) {
                value |= (packet[at++] & 0xFF) << 8 * i;
            }
            return value;
        }

        String text() {
            StringBuilder text = new StringBuilder();
            for (int c = number(1); c != 0; c = number(1)) {
                text.append((char) c);
            }
            return text.toString();
        }
    }
}
