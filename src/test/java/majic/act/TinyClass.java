package majic.act;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;

/** Makes minimal class files. */
public final class TinyClass {
    private static final int PUBLIC_SUPER = 0x21;

    private TinyClass() {}

    /** Returns an empty class with a name and a version. */
    public static byte[] of(String name, int major) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            out.writeInt(0xCAFEBABE);
            out.writeInt(major);
            out.writeShort(5);
            writeClass(out, name, 1);
            writeClass(out, "java.lang.Object", 3);
            for (int number : new int[] {PUBLIC_SUPER, 2, 4, 0, 0, 0, 0}) {
                out.writeShort(number);
            }
        } catch (IOException e) {
            throw new AssertionError("memory takes what is written to it", e);
        }
        return bytes.toByteArray();
    }

    private static void writeClass(DataOutputStream out, String name, int index) throws IOException {
        out.writeByte(1);
        out.writeUTF(name.replace('.', '/'));
        out.writeByte(7);
        out.writeShort(index);
    }
}
