package majic.act.make;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.time.LocalDateTime;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import majic.act.file.ActContents;
import majic.act.file.ActManifest;

/** Packs an act's file. The same contents give the same bytes, so that a consent given once stays valid. */
final class ActWriter {
    /** Later than the earliest time of zip files, with which Java also stores a time that depends on the time zone. */
    private static final LocalDateTime NO_TIME = LocalDateTime.of(1980, 2, 1, 0, 0);

    private ActWriter() {}

    /**
     * Packs a file.
     *
     * @param manifest the file's manifest
     * @param files the classes and the files beside them, by path
     * @param data the object stream of the act
     */
    static byte[] pack(ActManifest manifest, Map<String, byte[]> files, byte[] data) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream out = new ZipOutputStream(bytes)) {
            put(out, ActManifest.PATH, manifest.bytes());
            put(out, ActContents.DATA, data);
            for (Map.Entry<String, byte[]> one : new TreeMap<>(files).entrySet()) {
                put(out, one.getKey(), one.getValue());
            }
        } catch (IOException e) {
            throw new IllegalStateException("memory takes what is written to it", e);
        }
        return bytes.toByteArray();
    }

    private static void put(ZipOutputStream out, String path, byte[] bytes) throws IOException {
        ZipEntry entry = new ZipEntry(path);
        entry.setTimeLocal(NO_TIME);
        out.putNextEntry(entry);
        out.write(bytes);
        out.closeEntry();
    }
}
