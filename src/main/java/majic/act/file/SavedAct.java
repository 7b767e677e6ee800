package majic.act.file;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.NotSerializableException;
import java.io.ObjectOutputStream;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Optional;
import majic.act.Blame;
import majic.act.MajicAct;
import org.jspecify.annotations.Nullable;

/** Writes an act to an object stream, and finds the fields that cannot be saved. */
public final class SavedAct {
    private SavedAct() {}

    /**
     * Saves an act.
     *
     * @return its object stream, which can be read back
     * @throws Unfit if a field cannot be saved; the message names it
     */
    public static byte[] of(MajicAct act, Family family) throws IOException {
        try {
            byte[] stream = bytes(act);
            readBack(stream, act, family);
            return stream;
        } catch (IOException e) {
            throw new Unfit(badField(act, family).orElseGet(() -> reason(e)), e);
        }
    }

    private static byte[] bytes(@Nullable Object saved) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(saved);
        }
        return bytes.toByteArray();
    }

    private static void readBack(byte[] stream, MajicAct act, Family family) throws IOException {
        try {
            ActObjectInput.read(stream, family::has, act.getClass().getClassLoader());
        } catch (RuntimeException | Error e) {
            throw new Unfit("failed in its own code when it was read: " + Blame.named(e), e);
        }
    }

    private static Optional<String> badField(MajicAct act, Family family) {
        for (Class<?> type = act.getClass(); type != MajicAct.class; type = type.getSuperclass()) {
            for (Field field : type.getDeclaredFields()) {
                Optional<String> bad = saved(field) ? problem(field, act, family) : Optional.empty();
                if (bad.isPresent()) {
                    return bad;
                }
            }
        }
        return Optional.empty();
    }

    private static boolean saved(Field field) {
        return !Modifier.isStatic(field.getModifiers()) && !Modifier.isTransient(field.getModifiers());
    }

    private static Optional<String> problem(Field field, MajicAct act, Family family) {
        try {
            field.setAccessible(true);
            readBack(bytes(new ArrayList<>(Collections.singletonList(field.get(act)))), act, family);
            return Optional.empty();
        } catch (IOException e) {
            return Optional.of("cannot be saved: its field '" + field.getName() + "' " + reason(e)
                    + "; make the field transient and fill it in behave()");
        } catch (IllegalAccessException e) {
            return Optional.empty();
        }
    }

    private static String reason(IOException e) {
        return e instanceof NotSerializableException
                ? "holds a " + e.getMessage() + ", which cannot be saved"
                : String.valueOf(e.getMessage());
    }
}
