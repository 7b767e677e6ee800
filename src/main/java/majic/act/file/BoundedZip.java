package majic.act.file;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipInputStream;

/** Unpacks a jar into memory, with size limits that also hold for highly compressed data. */
public final class BoundedZip {
    /** The largest size of a file, bytes. */
    static final int MAX_FILE_BYTES = 16 << 20;

    private static final int MAX_ENTRIES = 2_000;
    /** The largest size of one unpacked entry, bytes. */
    public static final int MAX_ENTRY_BYTES = 4 << 20;

    private static final int MAX_UNPACKED_BYTES = 32 << 20;

    private static final int DIRECTORY_END = 0x06054b50;
    private static final int DIRECTORY_END_BYTES = 22;
    private static final int COUNT_AT = 10;
    private static final int MAX_COMMENT_BYTES = 0xFFFF;

    private final Map<String, byte[]> entries = new LinkedHashMap<>();
    private int count;
    private long unpackedBytes;

    private BoundedZip() {}

    /**
     * Unpacks a jar.
     *
     * @return the entries by path, without folders
     * @throws InvalidActException if it is damaged, truncated, or larger than an act may be
     */
    public static Map<String, byte[]> unpack(byte[] zip) throws IOException {
        BoundedZip unpacked = new BoundedZip();
        try (ZipInputStream in = new ZipInputStream(new ByteArrayInputStream(zip))) {
            for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
                unpacked.take(entry, in);
            }
        } catch (EOFException e) {
            throw new InvalidActException("is cut off", e);
        } catch (ZipException | IllegalArgumentException e) {
            throw new InvalidActException("is damaged (" + e.getMessage() + ")", e);
        }
        unpacked.checkDirectory(zip);
        return unpacked.entries;
    }

    private void take(ZipEntry entry, InputStream in) throws IOException {
        if (++count > MAX_ENTRIES) {
            throw new InvalidActException("has more than " + MAX_ENTRIES + " entries");
        }
        checkPath(entry.getName());
        byte[] bytes = read(entry.getName(), in);
        if (!entry.isDirectory() && entries.put(entry.getName(), bytes) != null) {
            throw new InvalidActException("has two entries " + entry.getName());
        }
    }

    private static void checkPath(String path) throws InvalidActException {
        if (path.startsWith("/") || path.contains("\\") || path.contains(":") || ("/" + path + "/").contains("/../")) {
            throw new InvalidActException("has an entry that points out of it: " + path);
        }
    }

    private byte[] read(String path, InputStream in) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        byte[] chunk = new byte[8192];
        for (int n = in.read(chunk); n >= 0; n = in.read(chunk)) {
            unpackedBytes += n;
            if (bytes.size() + n > MAX_ENTRY_BYTES || unpackedBytes > MAX_UNPACKED_BYTES) {
                throw new InvalidActException("unpacks to more than any act needs, at " + path);
            }
            bytes.write(chunk, 0, n);
        }
        return bytes.toByteArray();
    }

    /** Checks that the unpacked entries are those of the central directory, and that the file is complete. */
    private void checkDirectory(byte[] zip) throws InvalidActException {
        int lowest = Math.max(0, zip.length - DIRECTORY_END_BYTES - MAX_COMMENT_BYTES);
        for (int at = zip.length - DIRECTORY_END_BYTES; at >= lowest; at--) {
            if (int32(zip, at) == DIRECTORY_END) {
                if ((int32(zip, at + COUNT_AT) & 0xFFFF) != count) {
                    throw new InvalidActException("is damaged (its list of entries does not fit its entries)");
                }
                return;
            }
        }
        throw new InvalidActException("is cut off: it has no list of its entries");
    }

    private static int int32(byte[] bytes, int at) {
        return bytes[at] & 0xFF | (bytes[at + 1] & 0xFF) << 8 | (bytes[at + 2] & 0xFF) << 16 | bytes[at + 3] << 24;
    }
}
