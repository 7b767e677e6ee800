package majic.mavlink;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** The frames of a scripted vehicle, made and read without the driver's code (MAVLink sheet 2). */
final class VehicleFrames {
    private static final Map<Integer, Integer> EXTRAS = Map.ofEntries(
            Map.entry(0, 50),
            Map.entry(1, 124),
            Map.entry(11, 89),
            Map.entry(20, 214),
            Map.entry(21, 159),
            Map.entry(22, 220),
            Map.entry(23, 168),
            Map.entry(24, 24),
            Map.entry(30, 39),
            Map.entry(32, 185),
            Map.entry(33, 104),
            Map.entry(66, 148),
            Map.entry(75, 158),
            Map.entry(76, 152),
            Map.entry(77, 143),
            Map.entry(84, 143),
            Map.entry(132, 85),
            Map.entry(147, 154),
            Map.entry(148, 178),
            Map.entry(245, 130),
            Map.entry(253, 83),
            Map.entry(330, 23));

    private final ByteArrayOutputStream input = new ByteArrayOutputStream();
    private int sequence;

    /** A frame from the ground station. */
    record Got(int version, int id, int system, int component, byte[] payload) {
        private ByteBuffer fields() {
            return ByteBuffer.wrap(Arrays.copyOf(payload, 255)).order(ByteOrder.LITTLE_ENDIAN);
        }

        float f32(int offset) {
            return fields().getFloat(offset);
        }

        int u16(int offset) {
            return fields().getShort(offset) & 0xFFFF;
        }

        int i32(int offset) {
            return fields().getInt(offset);
        }

        int u8(int offset) {
            return fields().get(offset) & 0xFF;
        }

        String text(int offset, int length) {
            return new String(fields().array(), offset, length, StandardCharsets.US_ASCII).replace("\0", "");
        }
    }

    /** Begins the fields of a message. */
    static ByteBuffer fields(int length) {
        return ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** A frame of a vehicle. */
    byte[] frame(int version, int system, int component, int id, ByteBuffer fields) {
        byte[] payload = fields.array();
        int length = payload.length;
        while (version == 2 && length > 1 && payload[length - 1] == 0) {
            length--;
        }
        ByteBuffer frame = fields((version == 1 ? 8 : 12) + length);
        frame.put((byte) (version == 1 ? 0xFE : 0xFD)).put((byte) length);
        if (version == 1) {
            frame.put((byte) sequence++)
                    .put((byte) system)
                    .put((byte) component)
                    .put((byte) id);
        } else {
            frame.putShort((short) 0).put((byte) sequence++).put((byte) system).put((byte) component);
            frame.put((byte) id).put((byte) (id >> 8)).put((byte) (id >> 16));
        }
        frame.put(payload, 0, length);
        frame.putShort((short) crc(Arrays.copyOfRange(frame.array(), 1, frame.position()), EXTRAS.get(id)));
        return frame.array();
    }

    private static int crc(byte[] bytes, int extra) {
        int crc = 0xFFFF;
        for (int index = 0; index <= bytes.length; index++) {
            int mixed = ((index < bytes.length ? bytes[index] : extra) ^ crc) & 0xFF;
            mixed = (mixed ^ mixed << 4) & 0xFF;
            crc = crc >> 8 ^ mixed << 8 ^ mixed << 3 ^ mixed >> 4;
        }
        return crc & 0xFFFF;
    }

    /** Reads what came from the ground station; fails at a wrong checksum. */
    List<Got> read(byte[] bytes) {
        input.writeBytes(bytes);
        byte[] all = input.toByteArray();
        List<Got> frames = new ArrayList<>();
        int start = 0;
        while (start + 2 <= all.length) {
            boolean first = (all[start] & 0xFF) == 0xFE;
            int header = first ? 6 : 10;
            int end = start + header + (all[start + 1] & 0xFF);
            if (end + 2 > all.length) {
                break;
            }
            int id = first
                    ? all[start + 5] & 0xFF
                    : all[start + 7] & 0xFF | (all[start + 8] & 0xFF) << 8 | (all[start + 9] & 0xFF) << 16;
            int crc = crc(Arrays.copyOfRange(all, start + 1, end), EXTRAS.get(id));
            if (crc != (all[end] & 0xFF | (all[end + 1] & 0xFF) << 8)) {
                throw new AssertionError("a frame of message " + id + " has a wrong checksum");
            }
            int at = start + (first ? 3 : 5);
            frames.add(new Got(
                    first ? 1 : 2,
                    id,
                    all[at] & 0xFF,
                    all[at + 1] & 0xFF,
                    Arrays.copyOfRange(all, start + header, end)));
            start = end + 2;
        }
        input.reset();
        input.write(all, start, all.length - start);
        return frames;
    }
}
